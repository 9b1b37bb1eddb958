using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Two parallel flanks with round ends, cut in one pass: a slot or a key. Its flanks shift and tilt together; its ends follow
/// and stay tangent to both.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="Lists">In the order of cutting: at least two labels on a flank, one on the end after it, two on the other flank and one
/// on the other end.</param>
internal sealed record SlotFeature(
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    IReadOnlyList<IReadOnlyList<string>> Lists)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <summary>Code of the refusal of blocks or points that are not those of a slot.</summary>
    public const string NotASlot = "not-a-slot";

    /// <summary>Code of the refusal of a slot that would have no width or no flanks left.</summary>
    public const string SlotVanishes = "slot-vanishes";

    /// <inheritdoc/>
    public override FeatureKind Kind => SlotKind.Instance;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points => [.. Lists.SelectMany(l => l)];

    /// <inheritdoc/>
    public override IReadOnlyList<IReadOnlyList<string>> PointLists => Lists;

    internal override IReadOnlyList<(VerifiedQuantity Quantity, Func<IReadOnlyList<Point2>, double> Of)> Compared =>
        [(SlotKind.ComparedWidth, points => Fit(points, 0).WidthMm), (VerifiedQuantity.Length, points => Fit(points, 0).LengthMm)];

    internal override StraightElement? Element(int? flank) => flank is 1 or 2 ? new(Lists[flank == 1 ? 0 : 2], LineMethod.Total) : null;

    internal override FeatureEvaluation Evaluate(IReadOnlyList<Point2> theoretical, IReadOnlyList<Point2> actual, double u)
    {
        var (wanted, found) = (Fit(theoretical, 0), Fit(actual, u));
        var errors = found.StandardErrors;
        return new(
            [
                new(SlotKind.Width, wanted.WidthMm, found.WidthMm, errors.Width),
                new(SlotKind.Length, wanted.LengthMm, found.LengthMm, errors.Length),
                new(SlotKind.CenterX, wanted.Middle.X, found.Middle.X, errors.Middle.X),
                new(SlotKind.CenterY, wanted.Middle.Y, found.Middle.Y, errors.Middle.Y),
                new(
                    FeatureQuantity.Direction,
                    wanted.Direction.Direction.Normalized.Degrees,
                    found.Direction.Direction.Normalized.Degrees,
                    Angle.FromRadians(errors.Direction).Degrees),
            ],
            found.Residuals,
            []);
    }

    internal override Refusal? RefuseMap(NcPath path, FeatureMap map)
    {
        foreach (var pass in map.Passes)
        {
            if (CutSlot.Of(path, pass, 0) is { Slot: null, Stranger: var stranger })
            {
                const string Why = "it is neither a flank nor a round end of a slot. "
                    + "Name the two flanks and the two ends alone, without the way in and out.";
                return At(path, stranger, NotASlot, Why);
            }

            int[] lists = [.. Lists.SelectMany((labels, list) => labels.Select(_ => list))];
            var wrong = Array.FindIndex([.. pass.Feet.Zip(lists)], f => path.Motions[f.First.Motion].IsArc != (f.Second % 2 == 1));
            if (wrong >= 0)
            {
                var (has, wants) = lists[wrong] % 2 == 1 ? ("a flank", "a round end") : ("a round end", "a flank");
                var why = $"the point {pass.Feet[wrong].Label} lies at {has}; expected {wants}. "
                    + "Name the points of a flank, of the end behind it, of the other flank and of the other end.";
                return At(path, pass.Feet[wrong].Motion, NotASlot, why);
            }
        }

        return null;
    }

    internal override Refusal? RefuseCut(FeatureCut cut)
    {
        var (slot, wanted) = Wanted(cut);
        var radius = Math.Min(slot.PathRadius, slot.Radius) + (wanted.Radius - slot.Radius);
        var flanks = (wanted.FirstCenter - wanted.SecondCenter).Dot(wanted.Direction);
        return radius > 0 && flanks > 0 ? null : At(
            cut.Path,
            cut.Pass.First,
            SlotVanishes,
            string.Create(
                CultureInfo.InvariantCulture,
                $"displaced as asked, its ends would have a radius of {radius:0.000} mm and its flanks a length of {flanks:0.000} mm. "
                    + $"The tool is too large for this slot, or the points are wrong."));
    }

    internal override IEnumerable<ElementWish> Wishes(FeatureCut cut)
    {
        var (slot, wanted) = Wanted(cut);
        return slot.Wishes(cut, wanted);
    }

    internal override IReadOnlyList<Point2> MeasuredOutline(MeasuredFeature measured) => Fit(measured.Actual, 0).Outline(SlotKind.Pieces);

    private (CutSlot Slot, MeasuredSlot Wanted) Wanted(FeatureCut cut)
    {
        var slot = CutSlot.Of(cut.Path, cut.Pass, cut.ToolDiameterMm).Slot!;
        return (slot, Fit([.. cut.Pass.Feet.Select((f, i) => slot.BoundaryAt(cut.Path, f) + cut.Corrections[i])], 0));
    }

    private MeasuredSlot Fit(IReadOnlyList<Point2> points, double u)
    {
        var (lists, next) = (new List<IReadOnlyList<Point2>>(), 0);
        foreach (var labels in Lists)
        {
            lists.Add([.. points.Skip(next).Take(labels.Count)]);
            next += labels.Count;
        }

        return FeatureFits.Named(Name, () => MeasuredSlot.Fit(lists, u));
    }

    private Refusal At(NcPath path, int motion, string code, string message) =>
        FeatureRefusal.At(path, path.Motions[motion].Block, code, message, Name);
}
