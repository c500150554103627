// empty_file.hlsl: error: there is no function 'Main' to enter at
