using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Follows a program over a surface, and says by how much each end of a motion moves.</summary>
/// <param name="path">The program.</param>
/// <param name="walk">The surface under the ball.</param>
/// <param name="material">What may lie over the surface before it is finished.</param>
/// <param name="radiusMm">Radius of the ball.</param>
/// <param name="programsTip">True if the program moves the lowest point of the ball.</param>
internal sealed class FollowedPath(NcPath path, SurfaceWalk walk, StageMaterial material, double radiusMm, bool programsTip)
{
    private readonly List<PointWish> _points = [];
    private readonly RapidHeights _rapids = new(walk, material);

    // Where the motion before ended; null where that is not known.
    private SurfaceContact? _last;

    /// <summary>How many cuts end where the ball touches the surface.</summary>
    public int Touching { get; private set; }

    /// <summary>How many other motions end close enough to go along.</summary>
    public int Followed { get; private set; }

    /// <summary>The longest displacement, mm.</summary>
    public double LargestMm { get; private set; }

    /// <summary>The furthest that a place on a straight cut is displaced otherwise than its own contact asks for, mm.</summary>
    public double MisfitMm { get; private set; }

    /// <summary>Follows the whole path. Null, or why it cannot be displaced.</summary>
    public Refusal? Follow()
    {
        for (var i = 0; i < path.Motions.Length; i++)
        {
            var motion = path.Motions[i];
            var contact = motion.UnknownEnd == AxisSet.None ? walk.At(motion.End) : default(SurfaceContact?);
            if (contact is { } end)
            {
                if (Refused(motion, end) is { } refusal)
                {
                    return refusal;
                }

                Keep(i, motion, end);
            }

            _last = contact;
        }

        return Touching < 2 ? OffSurface() : null;
    }

    /// <summary>The displacements. What goes straight up from a moved place, or straight down to one, keeps to it in X and Y.</summary>
    public IReadOnlyList<PointWish> Points()
    {
        var moves = new SortedDictionary<int, Vector3>();
        foreach (var (motion, by) in _points)
        {
            moves[motion] = by;
        }

        foreach (var (motion, by) in _points)
        {
            var beside = by with { Z = 0 };
            var count = path.Motions.Length;
            for (var behind = motion + 1; behind < count && IsUpright(path.Motions[behind]) && moves.TryAdd(behind, beside); behind++)
            {
            }

            for (var before = motion; before > 0 && LeadsUpright(before) && moves.TryAdd(before - 1, beside); before--)
            {
            }
        }

        return [.. moves.Select(m => new PointWish(m.Key, m.Value))];
    }

    private Refusal? Refused(in NcMotion motion, SurfaceContact end)
    {
        var deepest = Deepest(motion, end);
        if (deepest < -SurfaceDisplacer.TouchMm)
        {
            return SurfaceDisplacer.Refuse(path, motion.Block, "program-in-surface", string.Create(
                CultureInfo.InvariantCulture,
                $"here the ball would cut {-deepest:0.000} mm into the surface. {Check}"));
        }

        if (motion.Kind == MotionKind.Rapid && _rapids.FirstTooLow(motion, _last, end) is var (place, overMm))
        {
            var gap = overMm < 0
                ? string.Create(CultureInfo.InvariantCulture, $"{-overMm:0.000} mm inside")
                : string.Create(CultureInfo.InvariantCulture, $"{overMm:0.000} mm over");
            return SurfaceDisplacer.Refuse(
                path,
                motion.Block,
                "rapid-too-low",
                $"at {PlaceText.Words(place)} this rapid move would take the ball {gap} the surface, over which up to "
                    + $"{StageMaterial.Text(material.Mm)} mm of material may lie before finishing: {material.Words}. Raise the heights of "
                    + $"approach, retract and links in the CAM system, or approach at the feed.");
        }

        return motion.IsArc && (deepest <= radiusMm || _last?.OverMm <= radiusMm)
            ? SurfaceDisplacer.Refuse(
                path,
                motion.Block,
                NcRefusalCodes.ArcForm,
                "an arc near the surface cannot follow points that are displaced each by its own vector. Post it as short straight lines.")
            : null;
    }

    // How far over the surface a motion comes closest to it.
    private double Deepest(in NcMotion motion, SurfaceContact end)
    {
        var deepest = end.OverMm;
        if (motion.IsCut && _last is { } from)
        {
            foreach (var (fraction, place) in Between(motion))
            {
                var its = walk.At(place);
                deepest = Math.Min(deepest, its.OverMm);
                MisfitMm = Touches(its) ? Math.Max(MisfitMm,
                    (its.Move - (from.Moved(radiusMm) * (1 - fraction)) - (end.Moved(radiusMm) * fraction)).Length) : MisfitMm;
            }
        }

        return deepest;
    }

    private void Keep(int index, in NcMotion motion, SurfaceContact end)
    {
        if (end.OverMm <= radiusMm)
        {
            var touches = Touches(end) && motion.IsCut;
            (Touching, Followed) = touches ? (Touching + 1, Followed) : (Touching, Followed + 1);
            LargestMm = Math.Max(LargestMm, end.Move.Length);
            _points.Add(new(index, end.Move));
        }
    }

    private Refusal OffSurface() => SurfaceDisplacer.Misread(path) ?? new Refusal("program-off-surface", string.Create(
        CultureInfo.InvariantCulture,
        $"No cut of the program touches the surface with a ball of {2 * radiusMm} mm within {SurfaceDisplacer.TouchMm} mm. {Check}"));

    // The program could move the other point of the ball.
    private string Check =>
        $"Check the tool's diameter, the work offset, and whether the program moves the {(programsTip ? "center" : "tip")} of the ball.";

    // Places on a straight cut, half a radius apart or closer, its middle at least; of one that is long beyond reason, so many that nothing
    // hangs.
    private IEnumerable<(double Fraction, Point3 Place)> Between(NcMotion motion)
    {
        var way = motion.End - motion.Start;
        var pieces = (int)Math.Clamp(Math.Ceiling(2 * way.Length / radiusMm), 2, 1000);
        for (var i = 1; i < pieces && !motion.IsArc; i++)
        {
            var fraction = (double)i / pieces;
            yield return (fraction, motion.Start + (way * fraction));
        }
    }

    private static bool Touches(SurfaceContact contact) => Math.Abs(contact.OverMm) <= SurfaceDisplacer.TouchMm;

    private bool LeadsUpright(int motion) => IsUpright(path.Motions[motion]) && path.Motions[motion - 1].UnknownEnd == AxisSet.None;

    private static bool IsUpright(in NcMotion motion) =>
        motion is { Kind: MotionKind.Rapid or MotionKind.Line, UnknownStart: AxisSet.None, UnknownEnd: AxisSet.None }
        && motion.Start.X == motion.End.X && motion.Start.Y == motion.End.Y;
}
