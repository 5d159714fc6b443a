i# Addresses of the manipulator: inputs and outputs, steps, transitions, graphs.

E0.0   = v0
E0.1   = v1
E0.2   = h0
E0.3   = h1
E0.4   = dcy
E0.5   = au

A0.0   = "V+"
A0.1   = "H-"
A0.2   = "H+"
A0.3   = "Voyant CI"

V20.0  = X0
V20.1  = X1
V20.2  = X2
V20.3  = X3
V21.0  = X10
V21.1  = X11
V21.2  = X12
V21.3  = X13

V80.0  = (0)
V80.1  = (1)
V80.2  = (2)
V80.3  = (3)
V81.0  = (10)
V81.1  = (11)
V81.2  = (12)
V81.3  = (13)

V0.0   = GS
V0.1   = Gauto
