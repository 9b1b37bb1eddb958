using System.Runtime.InteropServices;
using System.Text;
using ErrorMatching.Console;

using var cancellation = new CancellationTokenSource();

// Not disposed of: when the process ends, the Ctrl+C thread may just be starting to wait for it.
var ended = new ManualResetEventSlim();

// A cell finishes or gives back what it holds; other verbs have nothing to finish.
var grace = args.Where(a => !a.StartsWith('-')).Take(2).SequenceEqual(["cell", "run"]) ? TimeSpan.FromSeconds(10) : TimeSpan.FromSeconds(2);
using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);

// Neither writer is disposed of: the application flushes, and a second flush of a broken pipe would hide its exit code.
// The output of a large program is many megabytes, and each full buffer is a call of the system.
var bytes = Console.OpenStandardOutput();
var output = new StreamWriter(bytes, new UTF8Encoding(false), 1 << 14) { NewLine = "\n" };
var error = new StreamWriter(Console.OpenStandardError(), new UTF8Encoding(false)) { NewLine = "\n", AutoFlush = true };
var (noColor, kind) = (Environment.GetEnvironmentVariable("NO_COLOR"), Environment.GetEnvironmentVariable("TERM"));
var hasColor = Terminal.WantsColor(Console.IsOutputRedirected, noColor, kind);
var secrets = new SecretInput(
    new Lazy<TextReader>(() => new StreamReader(Console.OpenStandardInput(), new UTF8Encoding(false))),
    Console.IsInputRedirected ? null : () => Console.ReadKey(intercept: true),
    error);
var watched = !Console.IsErrorRedirected && kind != "dumb";
var terminal = new Terminal(output, error, hasColor)
{
    Input = new(Console.OpenStandardInput),
    Secrets = secrets,
    ProgramOutput = bytes,
    HasErrorColor = Terminal.WantsColor(Console.IsErrorRedirected, noColor, kind),
    Progress = watched ? error : null,
};
var exit = Application.Run(args, terminal, cancellation.Token);
ended.Set();
return exit;

void Stop(PosixSignalContext signal)
{
    // The first Ctrl+C requests a stop and, in case the work is waiting for a file, ends the process after a short time; the second one
    // ends it immediately. Outputs are complete either way.
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
