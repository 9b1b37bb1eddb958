using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// The path of the tool's center under G41 and G42, motion by motion against LinuxCNC's own interpreter, which prints it.
/// <c>ERRORMATCH_COMPENSATED_PROGRAMS</c> sets how many random programs (60 if not set).
/// </summary>
public sealed class CompensatedProgramTests
{
    private const double ToleranceMm = 0.0015;

    private static readonly int Programs =
        Environment.GetEnvironmentVariable("ERRORMATCH_COMPENSATED_PROGRAMS") is { } text ? int.Parse(text, CultureInfo.InvariantCulture) : 60;

    [Fact]
    public void The_path_of_the_center_is_that_of_rs274()
    {
        Rs274.IsNeeded();
        var (differences, refused, warned, ours) = (new List<string>(), 0, 0, new List<string>());
        for (var seed = 1; seed <= Programs; seed++)
        {
            var contour = new CompensatedContour(seed);
            var peer = Rs274.Run(contour.Text);
            var center = CompensatedPath.Of(
                NcInterpreter.Run(NcProgram.FromText(contour.Text, NcSyntax.LinuxCnc), NcDialects.LinuxCnc), ToolRadii.None);
            refused += peer.Refusal is null ? 0 : 1;
            if (FirstDifference(peer, center) is { } difference)
            {
                differences.Add($"seed {seed}: {difference}\n{contour.Text}");
            }
            else if (peer.Refusal is null && center.Refusal is { } refusal)
            {
                warned++;
                if (!CutsWrong(peer, center))
                {
                    ours.Add($"seed {seed}: {refusal.Message}\n{contour.Text}");
                }
            }
        }

        TestContext.Current.TestOutputHelper?.WriteLine(
            $"{Programs} programs, {refused} refused by rs274, {warned} by us only, {ours.Count} of these without a reason, {differences.Count} differ");
        Assert.True(differences.Count == 0, $"{differences.Count} of {Programs} programs differ, first {differences.FirstOrDefault()}");
        Assert.True(ours.Count == 0, $"{ours.Count} of {Programs} programs are refused without a reason, first {ours.FirstOrDefault()}");
    }

    // A program that rs274 accepts although the tool would cut something else: at the element that we refuse, its own path goes backwards on
    // a line, is on the wrong side of an arc's center, or goes along an arc by half a turn more or less than programmed.
    private static bool CutsWrong(PeerRun peer, CompensatedPath ours)
    {
        var motions = ours.Path.Motions;
        var block = ours.Refusal!.Place!.Line - 1;
        foreach (var i in ours.Path.MotionsOf(block!.Value))
        {
            var wanted = motions[i];
            for (var k = Math.Max(1, ours.Motions.Count - 4); k < Math.Min(peer.Motions.Count, ours.Motions.Count + 4); k++)
            {
                var (from, motion) = (wanted.Plane.Project(peer.Motions[k - 1].End), peer.Motions[k]);
                var to = wanted.Plane.Project(motion.End);
                if (motion.Kind == wanted.Kind && (wanted.IsArc ? IsWrongArc(wanted, motion, from, to) : IsBackwards(wanted, from, to)))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private static bool IsBackwards(in NcMotion wanted, Point2 from, Point2 to)
    {
        var (along, gone) = ((wanted.PlaneEnd - wanted.PlaneStart).Normalize(), to - from);

        // The way in does not begin beside the contour.
        var beside = wanted.Has(MotionFlags.CompensationSwitches) ? 5 : 0.0005;
        return gone.Dot(along) < 0 && Math.Abs(gone.Cross(along)) < (0.1 * gone.Length) + beside;
    }

    private static bool IsWrongArc(in NcMotion wanted, PeerMotion motion, Point2 from, Point2 to)
    {
        var (radial, wantedRadial) = (motion.Center - wanted.PlaneEnd, wanted.Center - wanted.PlaneEnd);
        if (radial.Dot(wantedRadial) < 0 && Math.Abs(radial.Cross(wantedRadial)) < 1e-2 * radial.Length * wantedRadial.Length)
        {
            return true;
        }

        var turns = wanted.Kind == MotionKind.ArcCounterClockwise;
        var (was, now) = (Arc2.Between(wanted.PlaneStart, wanted.PlaneEnd, wanted.Center, turns).Sweep,
            Arc2.Between(from, to, motion.Center, turns).Sweep);
        return motion.Center.DistanceTo(wanted.Center) < 0.002 && Math.Abs(was.Radians - now.Radians) > 3;
    }

    // In each coordinate, as rs274 rounds what it prints.
    private static double Largest(Vector3 v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));

    private static double Largest(Vector2 v) => Math.Max(Math.Abs(v.X), Math.Abs(v.Y));

    private static string? FirstDifference(PeerRun peer, CompensatedPath ours)
    {
        var count = Math.Min(peer.Motions.Count, ours.Motions.Count);
        for (var i = 0; i < count; i++)
        {
            var (theirs, own) = (peer.Motions[i], ours.Motions[i]);
            var line = ours.Path.Motions.BlockOf(own.Motion) + 1;
            var wrong = theirs.Kind != own.Kind ? "kind"
                : Largest(theirs.End - own.End) > ToleranceMm + (theirs.ResolutionMm / 2) ? "end"
                : own.IsArc && Largest(theirs.Center - own.Center) > ToleranceMm + (theirs.ResolutionMm / 2) ? "center"
                : theirs.Turns != own.Turns ? "turns"
                : null;
            if (wrong is not null)
            {
                return FormattableString.Invariant(
                    $"motion {i}, {wrong}: N{theirs.Line} {theirs.Kind} to {theirs.End} about {theirs.Center} turns {theirs.Turns}, ours N{line} {own.Kind} to {own.End} about {own.Center} turns {own.Turns} {peer.Refusal} {ours.Refusal}");
            }
        }

        return peer.Refusal is not null && ours.Refusal is null ? $"only rs274 refuses it: {peer.Refusal}"
            : peer.Refusal is null && ours.Refusal is null && peer.Motions.Count != ours.Motions.Count
                ? $"rs274 has {peer.Motions.Count} motions, we have {ours.Motions.Count}"
            : null;
    }
}
