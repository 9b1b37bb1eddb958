using System.Runtime.InteropServices;
using ErrorMatching.Console;

using var cancellation = new CancellationTokenSource();

// Not disposed of: when the process ends, the Ctrl+C thread may just be starting to wait for it.
var ended = new ManualResetEventSlim();

// A cell finishes or gives back what it holds; other verbs have nothing to finish.
var grace = args.Where(a => !a.StartsWith('-')).Take(2).SequenceEqual(["cell", "run"]) ? TimeSpan.FromSeconds(10) : TimeSpan.FromSeconds(2);
using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);

var exit = Application.Run(args, Terminal.OfProcess(), cancellation.Token);
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
