# Addresses of the manipulator with modes: inputs and outputs, the memory of V+ in step 32 (a bit of its own in
# the corrected listing only), steps, transitions, graphs.

E0.0   = v0
E0.1   = v1
E0.2   = h0
E0.3   = h1

E1.0   = dcy
E1.1   = manu
E1.2   = auto
E1.3   = au

E1.4   = vh
E1.5   = vv
E1.6   = a
E1.7   = b

A0.0   = "V+"
A0.1   = "H-"
A0.2   = "H+"
A0.3   = "Voyant CI"
A0.4   = "Voyant Auto"
A0.5   = "Voyant Manu"

V6.2   = manual_up

V20.0  = X0
V20.1  = X1
V20.2  = X2
V20.3  = X3
V21.0  = X10
V21.1  = X11
V21.2  = X12
V21.3  = X13
V21.4  = X14
V22.0  = X20
V22.1  = X21
V22.2  = X22
V22.3  = X23
V23.0  = X30
V23.1  = X31
V23.2  = X32

V80.0  = (0)
V80.1  = (1)
V80.2  = (2)
V80.3  = (3)
V81.0  = (10)
V81.1  = (11)
V81.2  = (12)
V81.3  = (13)
V81.4  = (14)
V81.5  = (15)
V82.0  = (20)
V82.1  = (21)
V82.2  = (22)
V82.3  = (23)
V83.0  = (30)
V83.1  = (31)
V83.2  = (32)
V83.3  = (33)

V0.0   = GS
V0.1   = GC
V0.2   = Gauto
V0.3   = Gmanu
