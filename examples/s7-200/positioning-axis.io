# Addresses of the positioning axis: inputs and outputs, the request, steps, transitions, the graph.

E0.0   = p0
E0.1   = p1
E0.2   = p2
E0.3   = p3

E0.4   = b0
E0.5   = b1
E0.6   = b2
E0.7   = b3

A0.0   = "Marche Moteur"
A0.1   = "Sens Moteur"
A0.2   = "Voyant Droite"
A0.3   = "Voyant Gauche"

V104.0 = r0
V104.1 = r1
V104.2 = r2
V104.3 = r3

V20.0  = X0
V20.1  = X1
V20.2  = X2
V20.3  = X3
V20.4  = X4
V20.5  = X5

V80.0  = (0)
V80.1  = (1)
V80.2  = (2)
V80.3  = (3)
V80.4  = (4)
V80.5  = (5)
V80.6  = (6)
V80.7  = (7)

V0.0   = GPN
