using System.Diagnostics;
using System.Diagnostics.Metrics;

namespace ErrorMatching.Cell;

/// <summary>Metrics and traces of a cell under the name <c>ErrorMatching.Cell</c>. They cost nothing without a listener.</summary>
internal static class CellTelemetry
{
    /// <summary>Name of the source and of the meter.</summary>
    public const string Name = "ErrorMatching.Cell";

    private static readonly ActivitySource Source = new(Name);
    private static readonly Meter Meter = new(Name);

    private static readonly Counter<long> Steps = Meter.CreateCounter<long>(
        "errormatch.cell.steps", "{step}", "Steps taken, by the state that they led to.");

    private static readonly Histogram<double> Latency = Meter.CreateHistogram<double>(
        "errormatch.cell.arrived_to_verified",
        "s",
        "From the archived file to the program that was read back from the machine.",
        advice: new() { HistogramBucketBoundaries = [0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1, 2, 5, 10, 60, 600, 3600] });

    /// <summary>Reports the length of each slot's line until the result is disposed of.</summary>
    public static IDisposable Watch(Func<IEnumerable<(string Machine, string Slot, long Waiting)>> lines)
    {
        var meter = new Meter(Name);
        meter.CreateObservableGauge(
            "errormatch.cell.line",
            () => lines().Select(l => new Measurement<long>(l.Waiting, new("machine", l.Machine), new("slot", l.Slot))),
            "{correction}",
            "Corrections that stand in line for a slot.");
        return meter;
    }

    /// <summary>Starts the trace that follows a file from its arrival to the machine, even across restarts.</summary>
    public static Activity? Begin(string gauge, string fileName)
    {
        // A root activity, independent of the current one.
        Activity.Current = null;
        return Source.StartActivity("archive", ActivityKind.Consumer)?.SetTag("gauge", gauge).SetTag("file", fileName);
    }

    /// <summary>Starts a part of a correction's trace; null without a listener.</summary>
    public static Activity? Start(string part, Correction correction)
    {
        if (correction.Trace is null || !ActivityContext.TryParse(correction.Trace, null, isRemote: true, out var trace))
        {
            return null;
        }

        return Source.StartActivity(part, ActivityKind.Internal, trace)
            ?.SetTag("correction", correction.Id).SetTag("job", correction.Job).SetTag("serial", correction.Serial);
    }

    /// <summary>Counts a step.</summary>
    public static void Count(Correction now) =>
        Steps.Add(1, new KeyValuePair<string, object?>("state", now.State.ToString().ToLowerInvariant()));

    /// <summary>Records a program's arrival at its machine: the latency, and the whole path as one part of its trace.</summary>
    public static void Arrived(Correction verified, DateTimeOffset now)
    {
        var tags = new TagList { { "machine", verified.Machine }, { "slot", verified.Slot } };
        Latency.Record((now - verified.ArrivedAt).TotalSeconds, tags);
        if (verified.Trace is not null && ActivityContext.TryParse(verified.Trace, null, isRemote: true, out var trace))
        {
            using var whole = Source.StartActivity(
                "file to verified", ActivityKind.Internal, trace, [new("correction", verified.Id)], startTime: verified.ArrivedAt);
            whole?.SetEndTime(now.UtcDateTime);
        }
    }
}
