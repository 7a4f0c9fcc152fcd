"""Questions to a model that are no simulation: what a driven mechanism does, where it rests, how it vibrates.

kinematics        the motion that drivers prescribe
inverse_dynamics  the forces and torques that the drivers need for it
equilibrium       where the mechanism stays at rest, and whether it returns there
linearization     frequencies, damping and shapes of small vibrations
sensitivity       derivatives of the results of a run by parameters of the model

Beneath them is linkwork.constraints.
"""
