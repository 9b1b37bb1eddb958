using System.Collections.ObjectModel;
using ErrorMatching.Cell;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Fit of a piece and its counterpart, without and with compensation: measured on the counterpart cut for it, or
/// predicted until then.</summary>
/// <param name="Correction">The correction that produced the counterpart's program.</param>
/// <param name="Counterpart">The measurement of the counterpart cut with it; null while the result is predicted.</param>
/// <param name="JobName">Name of the job.</param>
/// <param name="Result">The mating errors, and the boundaries of the features.</param>
/// <param name="IsBeforeMeasured">True if the counterpart without compensation was measured, false if its nominal shape is used.</param>
public sealed record StoredPiece(
    Correction Correction,
    Correction? Counterpart,
    string JobName,
    VerificationResult Result,
    bool IsBeforeMeasured)
{
    /// <summary>True if the counterpart cut with the compensation was measured.</summary>
    public bool IsMeasured => Counterpart is not null;

    /// <summary>True if it is known how much the compensation helps: both counterparts are measured, or both are as designed and
    /// predicted.</summary>
    public bool TellsImprovement => IsBeforeMeasured || !IsMeasured;

    /// <summary>The number of the last measurement.</summary>
    public long LastId => Counterpart?.Id ?? Correction.Id;

    /// <summary>True if every mating error with compensation is within its limits.</summary>
    public bool IsWithin => Outside.Count == 0;

    /// <summary>The key points whose mating error with compensation is outside its limits, in the order of cutting.</summary>
    public IReadOnlyList<string> Outside => Result.Outside.Points;

    /// <summary>The points of <see cref="Outside"/> that are within their limits without compensation: the compensation makes
    /// them worse, for example next to a corner that follows its neighbors.</summary>
    public IReadOnlyList<string> PushedOut => Result.Outside.DrivenOut;

    /// <summary>The match that the counterpart was cut by; null if it is not in the store.</summary>
    public MatchReport? Match { get; init; }

    /// <summary>Half the 95 % interval about each predicted error, by key point; empty once the counterpart is measured, and for a
    /// report of an earlier version.</summary>
    public IReadOnlyDictionary<string, double> Intervals95Mm
    {
        get => IsMeasured ? ReadOnlyDictionary<string, double>.Empty : field;
        private init;
    } = ReadOnlyDictionary<string, double>.Empty;

    /// <summary>That of the largest error with compensation; null if it is not known.</summary>
    public double? LargestInterval95Mm => Interval95Mm(Result.WorstAfter.Label);

    /// <summary>The part and the measured counterpart, assembled; null if they do not tell, and for a predicted piece.</summary>
    public PairAssembly? Pair { get; private init; }

    /// <summary>The verdict on the counterpart that was measured; null while the result is predicted.</summary>
    public VerifyVerdict? Verdict { get; init; }

    /// <summary>The counterpart that the errors without compensation are based on; null if its nominal shape is used.</summary>
    public ReportInput? Before { get; init; }

    /// <summary>The measured errors compared with the predicted ones, in the order of cutting; empty while nothing is measured,
    /// or if no prediction is known.</summary>
    public IReadOnlyList<PredictionMiss> Misses => IsMeasured ? Match?.MissesOf(Result) ?? [] : [];

    /// <summary>Half the 95 % interval about the predicted error at a key point; null if it is not known.</summary>
    public double? Interval95Mm(string point) => Intervals95Mm.TryGetValue(point, out var half) ? half : null;

    /// <summary>The prediction in a match report: the deviation that was the basis of the decision, and what is predicted to
    /// remain.</summary>
    public static StoredPiece Predicted(Correction correction, MatchReport report)
    {
        ArgumentNullException.ThrowIfNull(correction);
        ArgumentNullException.ThrowIfNull(report);
        var isFeedback = correction.Piece == PieceWords.Counterpart;
        return new(correction, null, report.Job.Name, report.Prediction, isFeedback)
        {
            Match = report,
            Intervals95Mm = report.KeyPoints.Where(p => p.Interval95Mm is not null).ToDictionary(
                p => p.Point, p => p.Interval95Mm!.Value, StringComparer.Ordinal),
            Before = isFeedback ? new("counterpart", correction.FileName, correction.MeasurementSha256) : null,
        };
    }

    /// <summary>The piece that a counterpart was cut for, as measured.</summary>
    /// <param name="correction">The correction that produced the counterpart's program.</param>
    /// <param name="counterpart">The measurement of the counterpart.</param>
    /// <param name="report">Its report.</param>
    public static StoredPiece Measured(Correction correction, Correction counterpart, VerifyReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return new(correction, counterpart, report.Job.Name, report.Result, report.IsBeforeMeasured)
        {
            Before = report.Before,
            Verdict = report.Verdict,
            Pair = report.Pair,
        };
    }
}
