using System.CommandLine;
using ErrorMatching.Hmi;
using ErrorMatching.Hmi.Desktop;

if (!OperatingSystem.IsWindows())
{
    return StationCommand.Make(new(null, Console.Error, null, TimeProvider.System)).Parse(args).Invoke();
}

// A program with windows has no streams there: what the command line says goes to the log and into a window.
var log = new StationLog(StationLog.FileOfAccount, Console.Error, MessageWindow.Show, TimeProvider.System);
using var said = new StringWriter();
var exit = StationCommand.Make(log).Parse(args).Invoke(new InvocationConfiguration { Output = said, Error = said });
if (said.ToString().Trim() is { Length: > 0 } text)
{
    log.Fail(text);
}

return exit;
