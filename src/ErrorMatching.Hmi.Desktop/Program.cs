using ErrorMatching.Hmi.Desktop;

return StationCommand.Make().Parse(args).Invoke();
