using System.Runtime.InteropServices;
using System.Text;
using ErrorMatching.Console;

using var cancellation = new CancellationTokenSource();
// The first Ctrl+C asks the work to stop between two outputs; the second one is the system's own.
using var registration = PosixSignalRegistration.Create(PosixSignal.SIGINT, signal =>
{
    signal.Cancel = !cancellation.IsCancellationRequested;
    cancellation.Cancel();
});
// Neither writer is disposed: the application flushes, and a second flush of a broken pipe would hide its exit code.
var output = new StreamWriter(Console.OpenStandardOutput(), new UTF8Encoding(false)) { NewLine = "\n" };
var error = new StreamWriter(Console.OpenStandardError(), new UTF8Encoding(false)) { NewLine = "\n", AutoFlush = true };
return Application.Run(args, new Terminal(output, error, Terminal.WantsColor()), cancellation.Token);
