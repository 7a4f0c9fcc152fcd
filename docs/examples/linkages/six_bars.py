"""
Six links, seven hinges: Watt and Stephenson
============================================

The two chains of one freedom beyond the four-bar linkage. For each angle of the crank there are four ways to put each together, and
a motion stays in the one in which it begins.
"""

import linkwork as lw

watt = lw.simulate(lw.mechanisms.watt_six_bar(mode=1), t_end=1.5, step=5e-4)
stephenson = lw.simulate(lw.mechanisms.stephenson_six_bar(mode=1), t_end=1.5, step=5e-4)
for result in (watt, stephenson):
    print(result.manifest["model"], result.manifest["constraints"])

# %%
view_watt = watt.view()

# %%
view_stephenson = stephenson.view()
