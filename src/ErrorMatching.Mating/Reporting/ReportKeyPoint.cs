using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A key point in the report of a match. Points are in the part's frame unless stated otherwise.</summary>
public sealed record ReportKeyPoint
{
    /// <summary>Its label.</summary>
    public required string Point { get; init; }

    /// <summary>Name of its feature.</summary>
    public required string Feature { get; init; }

    /// <summary>Its designed position.</summary>
    public required Point2 Theoretical { get; init; }

    /// <summary>Its measured position on the part: the contact point, aligned.</summary>
    public required Point2 Actual { get; init; }

    /// <summary>Its measured position on the counterpart, if compensation is from the counterpart; otherwise null.</summary>
    public Point2? Counterpart { get; init; }

    /// <summary>Unit normal of the boundary, from the counterpart's material to its tool.</summary>
    public required Vector2 Normal { get; init; }

    /// <summary>Its designed position in the program's frame; null in reports of earlier versions.</summary>
    public Point2? InProgram { get; init; }

    /// <summary>Displacement of the program there, in the program's frame; zero if nothing is compensated.</summary>
    public required Vector2 Correction { get; init; }

    /// <summary>The deviation that the decision is based on, along the normal: of the part from the theoretical point, or from the
    /// counterpart.</summary>
    public required double DecidedMm { get; init; }

    /// <summary>Its excess over the acceptance limit.</summary>
    public required double ExcessMm { get; init; }

    /// <summary>The probability that it is within its limits without compensation; null for limits without width, and in reports older
    /// than decision rules.</summary>
    public double? ProbabilityBefore { get; init; }

    /// <summary>The probability that it will be within its limits with the program as written; null for limits without width, and in
    /// reports of earlier versions.</summary>
    public double? ProbabilityAfter { get; init; }

    /// <summary>The mating error without compensation, counterpart - part: the distance of the measured point from what the original
    /// program cuts.</summary>
    public required double UncompensatedMm { get; init; }

    /// <summary>The mating error that the corrected counterpart will leave: the distance of the measured point from what the program as
    /// written cuts.</summary>
    public required double PredictedMm { get; init; }

    /// <summary>Half the 95 % interval about both errors, from the uncertainty of the measurement; null in reports of earlier
    /// versions.</summary>
    public double? Interval95Mm { get; init; }

    /// <summary>Blocks of the original program that cut the point, by number.</summary>
    public IReadOnlyList<string> Blocks { get; init; } = [];

    /// <summary>Where the counterpart is to be, in the program's frame: <see cref="InProgram"/> with <see cref="Correction"/>.</summary>
    public Point2? Corrected => InProgram + Correction;

    /// <summary>Theoretical - actual, as in the paper.</summary>
    public Vector2 Deviation => Theoretical - Actual;

    /// <summary>Actual - theoretical along the normal.</summary>
    public double NormalMm => -Deviation.Dot(Normal);

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("point", Point);
        w.Text("feature", Feature);
        w.Point("theoretical", Theoretical);
        w.Point("actual", Actual);
        if (Counterpart is { } counterpart)
        {
            w.Point("counterpart", counterpart);
        }

        if (InProgram is { } place)
        {
            w.Point("inProgram", place);
        }

        w.Vector("deviation", Deviation);
        w.Vector("correction", Correction);
        w.Vector("normal", Normal);
        w.Number("normalMm", NormalMm);
        w.Number("decidedMm", DecidedMm);
        w.Number("excessMm", ExcessMm);
        w.Number("probabilityBefore", ProbabilityBefore);
        w.Number("probabilityAfter", ProbabilityAfter);
        w.Number("uncompensatedMm", UncompensatedMm);
        w.Number("predictedMm", PredictedMm);
        w.Number("interval95Mm", Interval95Mm);
        w.Texts("blocks", Blocks);
    }

    /// <summary>Reads what <see cref="Write"/> writes, without what follows from it.</summary>
    internal static ReportKeyPoint Read(ReportReader r) => new()
    {
        Point = r.Text("point"),
        Feature = r.Text("feature"),
        Theoretical = r.Point("theoretical"),
        Actual = r.Point("actual"),
        Counterpart = r.OptionalPoint("counterpart"),
        InProgram = r.OptionalPoint("inProgram"),
        Normal = r.Vector("normal"),
        Correction = r.Vector("correction"),
        DecidedMm = r.Number("decidedMm"),
        ExcessMm = r.Number("excessMm"),
        ProbabilityBefore = r.OptionalNumber("probabilityBefore"),
        ProbabilityAfter = r.OptionalNumber("probabilityAfter"),
        UncompensatedMm = r.OptionalNumber("uncompensatedMm") ?? -r.Number("decidedMm"),
        PredictedMm = r.Number("predictedMm"),
        Interval95Mm = r.OptionalNumber("interval95Mm"),
        Blocks = r.Texts("blocks"),
    };
}
