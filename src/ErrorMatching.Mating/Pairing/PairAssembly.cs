using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Whether a part goes together with the counterpart that a program will cut, and where it seats.</summary>
/// <remarks>Of the boundary between the outermost key points of each element, and of circles and slots all around. Form that no key point
/// shows is in it as far as the points tell its size.</remarks>
public sealed record PairAssembly
{
    /// <summary>True if it is more likely than not that the part goes together with the counterpart.</summary>
    public required bool Assembles { get; init; }

    /// <summary>The probability that it does, by what the gauge and the points leave open.</summary>
    public required double Probability { get; init; }

    /// <summary>The air at the tightest place of the best seat, mm, negative for an overlap: half of the possible boundaries have
    /// more. Null if the part can be lifted off everywhere at once, so that there is as much air as one leaves.</summary>
    public double? TightestMm { get; init; }

    /// <summary>The 95 % interval of that air; null without it.</summary>
    public PlayRange? Interval95Mm { get; init; }

    /// <summary>The places that determine the seat, at most four.</summary>
    public IReadOnlyList<PairContact> Contacts { get; init; } = [];

    /// <summary>The inside corners in which the tool leaves a round, and no point tells whether the part has one: the rest is of a part
    /// that has.</summary>
    public IReadOnlyList<PairCorner> RoundCorners { get; init; } = [];

    /// <summary>Names of the features of whose form between the key points nothing is known: the rest is of a perfect form.</summary>
    public IReadOnlyList<string> UnknownForms { get; init; } = [];

    /// <summary>How far the part can move; null if the expected boundaries do not go together.</summary>
    public PairPlay? Play { get; init; }

    /// <summary>The expected gaps along the boundary at the seat, in the order of its elements.</summary>
    public IReadOnlyList<PairGap> Gaps { get; init; } = [];

    /// <summary>True if whether it goes together depends on forms of which nothing is known. A part that can be lifted off goes
    /// together whatever they are.</summary>
    public bool DependsOnForms => UnknownForms.Count > 0 && TightestMm is not null;

    /// <summary>True if the part goes together with the counterpart, or overlaps it by no more than the limits of a mating error may
    /// allow. A pair without a wanted gap that is exactly right is one of these in half of all cases.</summary>
    /// <param name="limits">The limits of the mating error, of each feature.</param>
    public bool IsWithin(IEnumerable<ToleranceBand> limits) =>
        Assembles || Interval95Mm is not { } interval || interval.To >= -limits.Where(l => l.WidthMm > 0).Select(l => l.UpperMm)
            .DefaultIfEmpty(double.PositiveInfinity).Max();

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Flag("assembles", Assembles);
        w.Exact("probability", Probability);
        w.Number("tightestMm", TightestMm);
        WriteRange(w, "interval95Mm", Interval95Mm, null);
        w.List("contacts", Contacts, c => c.Write(w));
        w.List("roundCorners", RoundCorners, c => c.Write(w));
        w.Texts("unknownForms", UnknownForms);
        w.Optional("play", Play, p =>
        {
            WriteRange(w, "xMm", p.XMm, PairPlay.Free);
            WriteRange(w, "yMm", p.YMm, PairPlay.Free);
            WriteRange(w, "turnDeg", p.TurnDeg, PairPlay.Free);
        });
        w.List("gaps", Gaps, g => g.Write(w));
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static PairAssembly Read(ReportReader r) => new()
    {
        Assembles = r.Flag("assembles"),
        Probability = r.Number("probability"),
        TightestMm = r.OptionalNumber("tightestMm"),
        Interval95Mm = Range(r.OptionalNumbers("interval95Mm", 2)),
        Contacts = r.List("contacts", PairContact.Read),
        RoundCorners = r.OptionalList("roundCorners", PairCorner.Read),
        UnknownForms = r.OptionalTexts("unknownForms"),
        Play = r.OptionalObject("play") is { } play
            ? new(
                Range(play.NumbersOrWord("xMm", 2, PairPlay.Free)),
                Range(play.NumbersOrWord("yMm", 2, PairPlay.Free)),
                Range(play.NumbersOrWord("turnDeg", 2, PairPlay.Free)))
            : null,
        Gaps = r.OptionalList("gaps", PairGap.Read),
    };

    private static PlayRange? Range(IReadOnlyList<double>? ends) => ends is null ? null : new(ends[0], ends[1]);

    private static void WriteRange(ReportWriter w, string name, PlayRange? range, string? otherwise)
    {
        if (range is { } ends)
        {
            w.Numbers(name, [ends.From, ends.To]);
        }
        else
        {
            w.Text(name, otherwise);
        }
    }
}

/// <summary>A place that determines the seat of a pair.</summary>
/// <param name="Place">The place, in the part's frame.</param>
/// <param name="Feature">Name of its feature.</param>
/// <param name="Block">The block that cuts it, as written: <c>N130</c>.</param>
public sealed record PairContact(Point2 Place, string Feature, string Block)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Point("place", Place);
        w.Text("feature", Feature);
        w.Text("block", Block);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static PairContact Read(ReportReader r) => new(r.Point("place"), r.Text("feature"), r.Text("block"));
}

/// <summary>An inside corner in which the tool leaves a round.</summary>
/// <param name="Before">The block before it, as written: <c>N200</c>.</param>
/// <param name="After">The block after it.</param>
/// <param name="OverlapMm">By how much a part with a sharp corner would overlap there.</param>
public sealed record PairCorner(string Before, string After, double OverlapMm)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("before", Before);
        w.Text("after", After);
        w.Number("overlapMm", OverlapMm);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static PairCorner Read(ReportReader r) => new(r.Text("before"), r.Text("after"), r.Number("overlapMm"));
}

/// <summary>The gap between the pieces at a place, at their seat.</summary>
/// <param name="Feature">Name of its feature.</param>
/// <param name="Place">The part's boundary there, in its frame.</param>
/// <param name="Normal">Unit normal from the counterpart's material to its tool.</param>
/// <param name="GapMm">The gap, negative for an overlap.</param>
public sealed record PairGap(string Feature, Point2 Place, Vector2 Normal, double GapMm)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("feature", Feature);
        w.Point("place", Place);
        w.Vector("normal", Normal);
        w.Number("gapMm", GapMm);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static PairGap Read(ReportReader r) => new(r.Text("feature"), r.Point("place"), r.Vector("normal"), r.Number("gapMm"));
}

/// <summary>How far a part can move in its counterpart until they touch, from where the program puts it. Null where nothing stops
/// it.</summary>
/// <param name="XMm">The shift in x of the middle of the outline, whatever the part does otherwise.</param>
/// <param name="YMm">The shift in y of the middle of the outline.</param>
/// <param name="TurnDeg">The turn, counterclockwise.</param>
public sealed record PairPlay(PlayRange? XMm, PlayRange? YMm, PlayRange? TurnDeg)
{
    /// <summary>The word for a direction in which nothing stops the part.</summary>
    public const string Free = "free";
}

/// <summary>A range.</summary>
/// <param name="From">Its lower end.</param>
/// <param name="To">Its upper end.</param>
public readonly record struct PlayRange(double From, double To);
