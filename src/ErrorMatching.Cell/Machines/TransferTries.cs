using Polly;
using Polly.Retry;

namespace ErrorMatching.Cell;

/// <summary>How often a transfer is retried, and after which delays.</summary>
internal static class TransferTries
{
    private static readonly TimeSpan FirstWait = TimeSpan.FromMilliseconds(250);
    private static readonly TimeSpan LongestWait = TimeSpan.FromSeconds(10);

    /// <summary>Tries as often as the machine's settings say, with delays that double, from 0.25 s to 10 s. Only failures that a retry may
    /// resolve are retried.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="clock">Measures the delays.</param>
    /// <param name="failed">Called for each failed attempt that is followed by another, before the delay; for logs.</param>
    public static ResiliencePipeline For(MachineSettings machine, TimeProvider clock, Action<TransferTry>? failed = null)
    {
        ArgumentNullException.ThrowIfNull(machine);
        if (machine.Attempts <= 1)
            return ResiliencePipeline.Empty;

        return new ResiliencePipelineBuilder { TimeProvider = clock }
            .AddRetry(new RetryStrategyOptions
            {
                MaxRetryAttempts = machine.Attempts - 1,
                BackoffType = DelayBackoffType.Exponential,
                Delay = FirstWait,
                MaxDelay = LongestWait,
                ShouldHandle = args => ValueTask.FromResult(args.Outcome.Exception is TransportException { IsWorthAnotherTry: true }),
                OnRetry = args =>
                {
                    failed?.Invoke(new TransferTry(
                        machine.Name, args.AttemptNumber + 1, (TransportException)args.Outcome.Exception!, args.RetryDelay));
                    return ValueTask.CompletedTask;
                },
            })
            .Build();
    }
}

/// <summary>A failed attempt that is followed by another.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Number">Number of the attempt, from 1.</param>
/// <param name="Failure">Why it failed.</param>
/// <param name="Wait">Delay until the next attempt.</param>
internal sealed record TransferTry(string Machine, int Number, TransportException Failure, TimeSpan Wait);
