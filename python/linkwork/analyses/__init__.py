"""Questions to a model that are no simulation: what a driven mechanism does, where it rests, how it vibrates.

kinematics        the motion that drivers prescribe
inverse_dynamics  the forces and torques that the drivers need for it
equilibrium       where the mechanism stays at rest, and whether it returns there
linearization     frequencies, damping and shapes of small vibrations
sensitivity       derivatives of the results of a run by parameters of the model

Beneath them: equations (the terms of the equations of motion, sparse), row_choice (independent rows of D),
constraint_solver (the motions that constraints leave), tangent (small motions of bodies, derivatives along
them).
"""
