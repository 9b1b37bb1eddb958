using System.Globalization;
using System.Security.Cryptography;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>Displaces a finishing program that exists already: every point by the compensation of the place that the ball touches there, proved like any other change of a program.</summary>
/// <remarks>
/// The place is the foot of the ball's center on the surface (method.md, section 7: target = nominal - gain error). Where the ball does not touch, but is no further from touching than its radius, it goes along with its foot, so that leads
/// and links keep their distance. Further away nothing moves, but for moves straight up and down, which stay so. Beyond the edge of the surface the edge counts.
/// </remarks>
public static class SurfaceDisplacer
{
    /// <summary>How far a center may be from the surface's offset, inwards or outwards, and still be taken to touch, mm: the program's own chordal error and rounding.</summary>
    public const double TouchMm = 0.05;

    /// <summary>Displaces a program.</summary>
    /// <param name="surface">The nominal surface, in the program's work offset.</param>
    /// <param name="field">The systematic error along its normal.</param>
    /// <param name="gain">Share of the error that is compensated.</param>
    /// <param name="tool">The ball end mill.</param>
    /// <param name="program">The program.</param>
    /// <param name="dialect">Its control.</param>
    /// <param name="programsTip">True if it moves the lowest point of the ball along Z, false if the center.</param>
    /// <param name="measurementSha256">SHA-256 of the measurement that the error was found by: the new program's marker names it.</param>
    /// <returns>
    /// The program with its proof, or a refusal with the block: it is compensated already (<see cref="Marker.AlreadyCompensated"/>), nothing of it cuts the surface (<c>program-off-surface</c>), it cuts deeper than the surface (<c>program-in-surface</c>), arcs or places that are not known near the surface, what
    /// cannot be rewritten, or a proof that fails.
    /// </returns>
    /// <exception cref="NcException">The program is too large.</exception>
    public static NcOutcome<DisplacedProgram> Displace(PartSurface surface, ErrorField field, double gain, JobTool tool, ReadOnlyMemory<byte> program, NcDialect dialect, bool programsTip, string measurementSha256)
    {
        ArgumentNullException.ThrowIfNull(surface);
        ArgumentNullException.ThrowIfNull(field);
        ArgumentNullException.ThrowIfNull(tool);
        ArgumentNullException.ThrowIfNull(dialect);
        var path = NcInterpreter.Run(NcProgram.Read(program, dialect.Syntax), dialect);
        if (BeforeAll(path) is { } refusal)
        {
            return refusal;
        }

        var walk = new SurfaceWalk(surface, field, gain, tool.RadiusMm, programsTip);
        var points = new List<PointWish>();
        var (touching, followed, largest, misfit) = (0, 0, 0.0, 0.0);
        var last = default(SurfaceContact?);
        for (var i = 0; i < path.Motions.Length; i++)
        {
            var motion = path.Motions[i];
            if (motion.UnknownEnd != AxisSet.None)
            {
                last = null;
                continue;
            }

            var contact = walk.At(motion.End);
            var deepest = contact.OverMm;
            if (motion.IsCut && last is { } from)
            {
                foreach (var (fraction, place) in Between(motion, tool.RadiusMm))
                {
                    var its = walk.At(place);
                    deepest = Math.Min(deepest, its.OverMm);
                    misfit = Touches(its) ? Math.Max(misfit, (its.Move - (from.Moved(tool.RadiusMm) * (1 - fraction)) - (contact.Moved(tool.RadiusMm) * fraction)).Length) : misfit;
                }
            }

            if (deepest < -TouchMm)
            {
                return Refuse(path, motion.Block, "program-in-surface", string.Create(
                    CultureInfo.InvariantCulture,
                    $"here the ball would cut {-deepest:0.000} mm into the surface. Check the tool's diameter, the work offset, and whether the program moves the {(programsTip ? "center" : "tip")} of the ball."));
            }

            var isNear = contact.OverMm <= tool.RadiusMm;
            if (motion.IsArc && (isNear || deepest <= tool.RadiusMm || last?.OverMm <= tool.RadiusMm))
            {
                return Refuse(path, motion.Block, NcRefusalCodes.ArcForm, "an arc near the surface cannot follow points that are displaced each by its own vector. Post it as short straight lines.");
            }

            if (isNear)
            {
                var touches = Touches(contact) && motion.IsCut;
                (touching, followed) = touches ? (touching + 1, followed) : (touching, followed + 1);
                largest = Math.Max(largest, contact.Move.Length);
                points.Add(new(i, contact.Move));
            }

            last = contact;
        }

        if (touching < 2)
        {
            return Misread(path) ?? new NcRefusal("program-off-surface", "", 0, string.Create(
                CultureInfo.InvariantCulture,
                $"No cut of the program touches the surface with a ball of {2 * tool.RadiusMm} mm within {TouchMm} mm. Check the tool's diameter, the work offset, and whether the program moves the {(programsTip ? "center" : "tip")} of the ball."));
        }

        var wish = DisplacementWish.OfPoints(StraightUpAndDown(path, points));
        var rewrite = Rewriter.Apply(path, wish);
        if (!rewrite.IsUsable)
        {
            return rewrite.Refusal.Code == NcRefusalCodes.UnknownState ? Misread(path) ?? rewrite.Refusal : rewrite.Refusal;
        }

        var marker = rewrite.Value.Patches.Count == 0 ? null : new Marker(measurementSha256, Convert.ToHexStringLower(SHA256.HashData(program.Span)));
        var displaced = marker is null ? rewrite.Value.Program : NcProgram.Read(marker.InsertInto(rewrite.Value.Program), dialect.Syntax);
        var proof = Prover.Check(path, displaced, wish, rewrite.Value.LeastIncrementMm, marker?.TextIn(dialect.Syntax));
        return proof.Holds
            ? new DisplacedProgram(displaced, path, wish, rewrite.Value, proof, marker, touching, followed, largest, misfit)
            : proof.Failures[0];
    }

    // What is wrong with the program wherever it goes. A marker counts even where it is damaged: only what was compensated has one.
    private static NcRefusal? BeforeAll(NcPath path)
    {
        if (Marker.Find(path.Program) is [var (block, _), ..])
        {
            return Refuse(path, block, Marker.AlreadyCompensated, "the program carries a marker, so it follows a measured error already, which would be cut away twice. Begin from the original program as the CAM system posted it.");
        }

        return path.Refusal;
    }

    // Where the dialect is another's, everything behind the first unknown code goes wrong: that one is to blame.
    private static NcRefusal? Misread(NcPath path) => path.Problems is [var problem, ..]
        ? Refuse(path, problem.Block, NcRefusalCodes.UnknownState, $"{problem.Message} Behind it the program cannot be followed with certainty. Check that toolpath.dialect, {path.Dialect.Name}, is the control that the program was posted for.")
        : null;

    // Places on a straight cut, half a radius apart or closer, its middle at least; of one that is long beyond reason, so many that nothing hangs.
    private static IEnumerable<(double Fraction, Point3 Place)> Between(NcMotion motion, double radius)
    {
        var way = motion.End - motion.Start;
        var pieces = (int)Math.Clamp(Math.Ceiling(2 * way.Length / radius), 2, 1000);
        for (var i = 1; i < pieces && !motion.IsArc; i++)
        {
            var fraction = (double)i / pieces;
            yield return (fraction, motion.Start + (way * fraction));
        }
    }

    private static bool Touches(SurfaceContact contact) => Math.Abs(contact.OverMm) <= TouchMm;

    private static NcRefusal Refuse(NcPath path, int position, string code, string message)
    {
        var block = path.Program[position];
        var name = path.Program.NameOf(block);
        return new(code, name, block.Line, $"{name}: {message}");
    }

    // What goes straight up from a moved place, or straight down to one, keeps to it in X and Y.
    private static List<PointWish> StraightUpAndDown(NcPath path, List<PointWish> points)
    {
        var moves = new SortedDictionary<int, Vector3>();
        foreach (var (motion, by) in points)
        {
            moves[motion] = by;
        }

        foreach (var (motion, by) in points)
        {
            var beside = by with { Z = 0 };
            for (var behind = motion + 1; behind < path.Motions.Length && IsUpright(path.Motions[behind]) && moves.TryAdd(behind, beside); behind++)
            {
            }

            for (var before = motion; before > 0 && IsUpright(path.Motions[before]) && path.Motions[before - 1].UnknownEnd == AxisSet.None && moves.TryAdd(before - 1, beside); before--)
            {
            }
        }

        return [.. moves.Select(m => new PointWish(m.Key, m.Value))];
    }

    private static bool IsUpright(in NcMotion motion) => motion is { Kind: MotionKind.Rapid or MotionKind.Line, UnknownStart: AxisSet.None, UnknownEnd: AxisSet.None }
        && motion.Start.X == motion.End.X && motion.Start.Y == motion.End.Y;
}
