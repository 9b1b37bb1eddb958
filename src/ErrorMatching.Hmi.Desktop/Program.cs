using System.CommandLine;
using ErrorMatching.Hmi;
using ErrorMatching.Hmi.Desktop;

if (!OperatingSystem.IsWindows())
{
    return StationCommand.Make(new(null, Console.Error, null, TimeProvider.System)).Parse(args).Invoke();
}

// A program with windows has no streams there: what the command line says goes into a window, and what is wrong with it into the log too.
var log = new StationLog(StationLog.FileOfAccount, Console.Error, MessageWindow.ShowError, TimeProvider.System);
var command = StationCommand.Make(log).Parse(args);
if (command.Errors.Count > 0)
{
    log.Fail(string.Join(Environment.NewLine, command.Errors.Select(e => e.Message)));
    return StationCommand.WrongInput;
}

using var said = new StringWriter();
var exit = command.Invoke(new InvocationConfiguration { Output = said, Error = said });
if (said.ToString().Trim() is { Length: > 0 } text)
{
    MessageWindow.Show(text);
}

return exit;
