def import_sdf():pass
