using System.Runtime.InteropServices;
using System.Text;
using ErrorMatching.Console;

if (args is ["surface", "compensate", ..])
{
    Rehearsal.Begin();
}

using var cancellation = new CancellationTokenSource();

// Not disposed: at the end of the process the thread of a Ctrl+C may just begin to wait for it.
var ended = new ManualResetEventSlim();

// A cell finishes or gives back what it holds; anything else has nothing to finish.
var grace = args.Where(a => !a.StartsWith('-')).Take(2).SequenceEqual(["cell", "run"]) ? TimeSpan.FromSeconds(10) : TimeSpan.FromSeconds(2);
using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);

// Neither writer is disposed: the application flushes, and a second flush of a broken pipe would hide its exit code.
var output = new StreamWriter(Console.OpenStandardOutput(), new UTF8Encoding(false)) { NewLine = "\n" };
var error = new StreamWriter(Console.OpenStandardError(), new UTF8Encoding(false)) { NewLine = "\n", AutoFlush = true };
var hasColor = Terminal.WantsColor(Console.IsOutputRedirected, Environment.GetEnvironmentVariable("NO_COLOR"), Environment.GetEnvironmentVariable("TERM"));
var secrets = new SecretInput(new Lazy<TextReader>(() => new StreamReader(Console.OpenStandardInput(), new UTF8Encoding(false))), Console.IsInputRedirected ? null : () => Console.ReadKey(intercept: true), error);
var watched = !Console.IsErrorRedirected && Environment.GetEnvironmentVariable("TERM") != "dumb";
var exit = Application.Run(args, new Terminal(output, error, hasColor) { Secrets = secrets, Progress = watched ? error : null }, cancellation.Token);
ended.Set();
return exit;

void Stop(PosixSignalContext signal)
{
    // The first Ctrl+C asks the work to stop and, should it be waiting for a file, ends the process soon; the second one ends it at once. Outputs are whole either way.
    signal.Cancel = !cancellation.IsCancellationRequested;
    cancellation.Cancel();
    new Thread(EndAtLatest) { IsBackground = true }.Start();
}

void EndAtLatest()
{
    if (!ended.Wait(grace))
    {
        Environment.Exit((int)ExitCode.Cancelled);
    }
}
