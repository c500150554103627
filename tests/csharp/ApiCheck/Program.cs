return Penumbra.ApiCheck.Command.Run(args, Console.Out, Console.Error);
