// empty_file.hlsl: error: the entry point 'Main' is not defined
