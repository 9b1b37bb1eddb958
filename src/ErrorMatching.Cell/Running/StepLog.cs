using Serilog;
using Serilog.Events;

namespace ErrorMatching.Cell;

/// <summary>The format of steps in the log.</summary>
internal static class StepLog
{
    /// <summary>Logs a stored step.</summary>
    public static void Write(ILogger log, CorrectionState? from, Correction now, string basis)
    {
        var level = LevelOf(now.State);
        if (log.IsEnabled(level))
        {
            log.ForContext("From", from?.ToString().ToLowerInvariant())
                .ForContext("Job", now.Job)
                .ForContext("Serial", now.Serial)
                .ForContext("WorkOrder", now.WorkOrder)
                .ForContext("Machine", now.Machine).ForContext("Slot", now.Slot).ForContext("Trace", now.Trace)
                .Write(
                    level,
                    "{Correction} {FileName}: {State:l}: {Basis:l}",
                    now.Id,
                    now.FileName,
                    now.State.ToString().ToLowerInvariant(),
                    now.Code is { } code ? $"{code}: {basis}" : basis);
        }
    }

    private static LogEventLevel LevelOf(CorrectionState state) => state switch
    {
        CorrectionState.Verified or CorrectionState.Released or CorrectionState.Recorded or CorrectionState.Proposed =>
            LogEventLevel.Information,
        CorrectionState.Refused or CorrectionState.Superseded or CorrectionState.Rejected or CorrectionState.Reverted =>
            LogEventLevel.Warning,
        CorrectionState.Failed => LogEventLevel.Error,
        _ => LogEventLevel.Debug,
    };
}
