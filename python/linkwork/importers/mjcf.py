def import_mjcf():pass
