using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Displaces a finishing program that exists already: every point by the compensation of the place that the ball touches there,
/// proved like any other change of a program.</summary>
/// <remarks>
/// The place is the foot of the ball's center on the surface (method.md, section 7: target = nominal - gain error). Where the ball does not
/// touch, but is no further from touching than its radius, it goes along with its foot, so that leads and links keep their distance.
/// Further away nothing moves, but for moves straight up and down, which stay so. Beyond the edge of the surface the edge counts.
/// </remarks>
public static class SurfaceDisplacer
{
    /// <summary>How far a center may be from the surface's offset, inwards or outwards, and still be taken to touch, mm:
    /// the program's own chordal error and rounding.</summary>
    public const double TouchMm = 0.05;

    /// <summary>Displaces the finishing program of a job.</summary>
    /// <param name="surface">The nominal surface, in the program's work offset.</param>
    /// <param name="field">The systematic error along its normal.</param>
    /// <param name="job">The job: tool, gain, stock, and which point of the ball the program moves.</param>
    /// <param name="program">The program.</param>
    /// <param name="dialect">Its control.</param>
    /// <param name="measurementSha256">SHA-256 of the measurement that the error was found by: the new program's marker names it.</param>
    /// <param name="moreMm">By how much the piece may be higher than its stock, and the program is moved, mm.</param>
    /// <returns>
    /// The program with its proof, or a refusal with the block: it is compensated already (<see cref="Marker.AlreadyCompensated"/>),
    /// nothing of it cuts the surface (<c>program-off-surface</c>), it cuts deeper than the surface (<c>program-in-surface</c>), a rapid
    /// move goes through what may lie over the surface (<c>rapid-too-low</c>), arcs or places that are not known near the surface, what
    /// cannot be rewritten, or a proof that fails.
    /// </returns>
    /// <exception cref="InputException">The program is too large.</exception>
    public static Outcome<DisplacedProgram> Displace(
        PartSurface surface,
        ErrorField field,
        FreeformJob job,
        ReadOnlyMemory<byte> program,
        NcDialect dialect,
        string measurementSha256,
        double moreMm = 0)
    {
        ArgumentNullException.ThrowIfNull(surface);
        ArgumentNullException.ThrowIfNull(field);
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(dialect);
        ArgumentOutOfRangeException.ThrowIfNegative(moreMm);
        var material = StageMaterial.Before(job, CuttingStage.Finishing)
            .And(moreMm, "by which the piece was too high and the program is moved");
        return Displace(
            surface, field, job.Compensation.Gain, job.Tool, program, dialect, job.Toolpath.ProgramsTip, measurementSha256, material);
    }

    internal static Outcome<DisplacedProgram> Displace(
        PartSurface surface,
        ErrorField field,
        double gain,
        JobTool tool,
        ReadOnlyMemory<byte> program,
        NcDialect dialect,
        bool programsTip,
        string measurementSha256,
        StageMaterial material)
    {
        var path = NcInterpreter.Run(NcProgram.Read(program, dialect.Syntax), dialect);
        if (BeforeAll(path) is { } refusal)
        {
            return refusal;
        }

        var walk = new SurfaceWalk(surface, field, gain, tool.RadiusMm, programsTip);
        var followed = new FollowedPath(path, walk, material, tool.RadiusMm, programsTip);
        return followed.Follow() is { } off ? off : Proved(path, program, followed, measurementSha256);
    }

    private static Outcome<DisplacedProgram> Proved(
        NcPath path, ReadOnlyMemory<byte> program, FollowedPath followed, string measurementSha256)
    {
        var syntax = path.Dialect.Syntax;
        var wish = DisplacementWish.OfPoints(followed.Points());
        var rewrite = Rewriter.Apply(path, wish);
        if (!rewrite.IsUsable)
        {
            return rewrite.Refusal.Code == NcRefusalCodes.UnknownState ? Misread(path) ?? rewrite.Refusal : rewrite.Refusal;
        }

        var marker = rewrite.Result.Patches.Count == 0
            ? null
            : new Marker(measurementSha256, ContentHash.Sha256(program.Span));
        var displaced = marker is null ? rewrite.Result.Program : NcProgram.Read(marker.InsertInto(rewrite.Result.Program), syntax);
        var proof = Prover.Check(path, displaced, wish, rewrite.Result.LeastIncrementMm, marker?.TextIn(syntax));
        return proof.Holds
            ? new DisplacedProgram(
                displaced,
                path,
                wish,
                rewrite.Result,
                proof,
                marker,
                followed.Touching,
                followed.Followed,
                followed.LargestMm,
                followed.MisfitMm)
            : proof.Failures[0];
    }

    // What is wrong with the program wherever it goes. A marker counts even where it is damaged: only what was compensated has one.
    private static Refusal? BeforeAll(NcPath path)
    {
        if (Marker.Find(path.Program) is [var (block, _), ..])
        {
            return Refuse(
                path,
                block,
                Marker.AlreadyCompensated,
                "the program carries a marker, so it follows a measured error already, which would be cut away twice. Begin from the "
                    + "original program as the CAM system posted it.");
        }

        return path.Refusal;
    }

    // Where the dialect is another's, everything behind the first unknown code goes wrong: that one is to blame.
    internal static Refusal? Misread(NcPath path) => path.Problems is [var problem, ..]
        ? Refuse(
            path,
            problem.Block,
            NcRefusalCodes.UnknownState,
            $"{problem.Message} Behind it the program cannot be followed with certainty. Check that toolpath.dialect, "
                + $"{path.Dialect.Name}, is the control that the program was posted for.")
        : null;

    internal static Refusal Refuse(NcPath path, int position, string code, string message) =>
        BlockRefusal.At(path.Program, position, code, message);
}
