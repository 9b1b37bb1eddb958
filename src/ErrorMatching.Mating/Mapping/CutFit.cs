using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>How an uninterrupted cut fits the key points of a sought boundary.</summary>
/// <param name="Cut">The cut.</param>
/// <param name="Feet">Its nearest place to each of them.</param>
/// <param name="WantedMm">Required distance from all of them: a tool radius; 0 under cutter compensation; if the tool is unknown, the
/// middle of the distances found.</param>
/// <param name="Core">From the first motion that a key point needs to the last; valid only if <paramref name="Fault"/> is none.</param>
/// <param name="IsAgainst">True if the cut passes the key points from last to first.</param>
/// <param name="Fault">Why it does not cut the boundary.</param>
internal sealed record CutFit(
    FoundPass Cut, IReadOnlyList<SoughtFoot> Feet, double WantedMm, FoundPass Core, bool IsAgainst, CutFault Fault)
{
    /// <summary>Largest difference of a key point's distance from the required one.</summary>
    public double MissMm => Feet.Max(f => Math.Abs(f.DistanceMm - WantedMm));

    // Places on a path closer than an NC word can express are the same.
    private const double SamePlaceMm = 1e-6;

    // Index of the first key point that the cut passes twice; -1 if there is none.
    private int Twice { get; init; }

    /// <summary>True if the core is the whole boundary, regardless of where its key points end.</summary>
    public bool IsWhole { get; init; }

    /// <summary>Judges a cut.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="cut">The cut.</param>
    /// <param name="boundary">The boundary, with at least two key points.</param>
    /// <param name="radius">Radius of the tool, mm; null if unknown.</param>
    /// <param name="mapMm">Allowed distance of a key point from where it belongs.</param>
    public static CutFit Fit(NcPath path, FoundPass cut, SoughtBoundary boundary, double? radius, double mapMm)
    {
        SoughtFoot[] feet = [.. boundary.Points.Select(p => SoughtFoot.Find(path, cut, p.At))];
        var compensated = feet[0].IsCompensated;
        var (least, most) = (feet.Min(f => f.DistanceMm), feet.Max(f => f.DistanceMm));
        var wanted = compensated ? 0 : radius ?? (least + most) / 2;

        // If an end of the boundary is at a corner of the path, use the motion inside the boundary.
        var (ahead, back) = (new FoundPass(feet[0].Last, feet[^1].First), new FoundPass(feet[^1].Last, feet[0].First));

        // At a joint the lead-in or lead-out is just as near; a key point within a motion shows which one is meant.
        var whole = boundary.Kind?.WholeOf(path, cut, feet.Where(f => f.First == f.Last && !f.IsTwice).Append(feet[0]).First().First);
        var twice = Enumerable.Range(0, feet.Length).FirstOrDefault(
            i => whole is null ? feet[i].IsTwice : ComesBack(path, cut, whole, feet[i], boundary.Points[i].At), -1);
        var isAgainst = whole is null && ahead.First > ahead.Last;
        var core = whole ?? (isAgainst ? back : ahead);
        var fault = most - wanted > mapMm || wanted - least > mapMm ? CutFault.Apart
            : Array.Exists(feet, f => f.IsCompensated != compensated) ? CutFault.Compensation
            : !compensated && Array.Exists(feet, f => f.IsLeft != feet[0].IsLeft) ? CutFault.Sides
            : twice >= 0 ? CutFault.Twice
            : core.First > core.Last || Array.Exists(feet, f => f.Last < core.First || f.First > core.Last) ? CutFault.Order
            : CutFault.None;
        return new(cut, feet, wanted, core, isAgainst, fault) { IsWhole = whole is not null, Twice = twice };
    }

    // A closed contour passes its start again at its end, and so do lead-in and lead-out. Only a cut beyond these is a second pass.
    private static bool ComesBack(NcPath path, FoundPass cut, FoundPass whole, SoughtFoot foot, Point2 point) =>
        new[] { cut with { Last = whole.First - 2 }, cut with { First = whole.Last + 2 } }
            .Any(rest => rest.First <= rest.Last && SoughtFoot.Find(path, rest, point).DistanceMm <= foot.DistanceMm + SamePlaceMm);

    /// <summary>Explains why it does not cut the boundary.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="boundary">The boundary.</param>
    /// <param name="radius">Radius of the tool, mm; null if unknown.</param>
    /// <param name="mapMm">Allowed distance of a key point from where it belongs.</param>
    public Refusal Refuse(NcPath path, SoughtBoundary boundary, double? radius, double mapMm)
    {
        var worst = Enumerable.Range(0, Feet.Count).MaxBy(i => Math.Abs(Feet[i].DistanceMm - WantedMm));
        return Fault switch
        {
            CutFault.Apart when radius is null && !Feet[0].IsCompensated => At(worst, BoundarySearch.NotFound, string.Create(
                CultureInfo.InvariantCulture,
                $"of all cuts this is the nearest, and its points lie {Feet.Min(f => f.DistanceMm):0.000} to "
                    + $"{Feet.Max(f => f.DistanceMm):0.000} mm from the path; expected one distance for all (within {mapMm:0.###} mm). "
                        + $"Check "
                    + $"the frame and the points")),
            CutFault.Apart => At(worst, BoundarySearch.NotFound, string.Create(
                CultureInfo.InvariantCulture,
                $"of all cuts this is the nearest, and the point {boundary.Points[worst].Label} lies {Feet[worst].DistanceMm:0.000} mm "
                    + $"from the path; expected {Where} (within {mapMm:0.###} mm). Check the frame, the tool diameter and the "
                    + $"points")) with
            { Found = FoundMm(Feet[worst].DistanceMm) },
            CutFault.Compensation => At(
                Other(f => f.IsCompensated),
                BoundarySearch.NotFound,
                $"cutter compensation is not the same at the points {boundary.Points[0].Label} and "
                    + $"{boundary.Points[Other(f => f.IsCompensated)].Label}"),
            CutFault.Sides => At(
                Other(f => f.IsLeft),
                FeatureMapper.SidesDiffer,
                $"the points {boundary.Points[0].Label} and {boundary.Points[Other(f => f.IsLeft)].Label} lie on different sides of the "
                    + $"path, so the material cannot be told. Check the frame and the points"),
            CutFault.Twice => At(
                Twice,
                BoundarySearch.CutTwice,
                $"this cut passes the point {boundary.Points[Twice].Label} twice without a break, so it cannot be told which of its "
                    + $"blocks are meant. Check the point"),
            _ => At(
                0,
                BoundarySearch.NotFound,
                "this cut does not lead past the points one behind the other, as they are named. Check the points and their order"),
        };

        Refusal At(int point, string code, string message) =>
            BoundarySearch.Refuse(path, Feet[point].First, code, message, boundary.Name, boundary.Points[point].Label);
    }

    // As a draft shows it beside the field.
    internal static string FoundMm(double distance) => string.Create(CultureInfo.InvariantCulture, $"{distance:0.000} mm");

    private string Where =>
        Feet[0].IsCompensated
            ? "it on the path, since cutter compensation is active"
            : string.Create(CultureInfo.InvariantCulture, $"{WantedMm:0.###} mm, one tool radius");

    private int Other(Func<SoughtFoot, bool> of) => Enumerable.Range(0, Feet.Count).First(i => of(Feet[i]) != of(Feet[0]));
}
