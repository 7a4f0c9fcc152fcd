"""What constraints leave and ask for, pose by pose.

equations     the terms of the equations of motion, sparse
row_choice    independent rows of D
solver        the motions that constraints leave
continuation  the motion that drivers prescribe, followed on one branch
crossing      singular poses that it passes
impasse       where it ends
tangent       small motions of bodies, derivatives along them
"""
