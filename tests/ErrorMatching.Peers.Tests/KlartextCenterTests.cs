using System.Globalization;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// The path of the tool's center under RL and RR between the way in and the way out, motion by motion against that of LinuxCNC's own
/// interpreter for the same contour under G41 and G42: outside corners are arcs on both, inside corners intersections.
/// <c>ERRORMATCH_COMPENSATED_PROGRAMS</c> sets how many random contours (15 if not set).
/// </summary>
public sealed class KlartextCenterTests
{
    private const double ToleranceMm = 0.0015;

    private static readonly int Contours = Environment.GetEnvironmentVariable("ERRORMATCH_COMPENSATED_PROGRAMS") is { } text
        ? int.Parse(text, CultureInfo.InvariantCulture) : 15;

    [Fact]
    public void The_same_contour_gives_the_same_path_of_the_center()
    {
        Rs274.IsNeeded();
        var (failures, refused, wrong, own, motions) = (new List<string>(), 0, 0, 0, 0);
        for (var seed = 1; seed <= Contours; seed++)
        {
            var contour = new TwoTongueContour(seed);
            var peer = Rs274.Run(contour.Iso);
            var center = CompensatedPath.Of(
                NcInterpreter.Run(NcProgram.FromText(contour.Klartext, NcSyntax.Klartext), NcDialects.HeidenhainKlartext),
                ToolRadii.Of(contour.Radius),
                TestContext.Current.CancellationToken);
            refused += peer.Refusal is not null ? 1 : 0;
            if (peer.Refusal is null && center.Refusal is not null && CompensatedProgramTests.CutsWrong(peer, center))
            {
                wrong++;
            }
            else if (peer.Refusal is not null && center.Refusal is null && GrowsArc(contour.Iso))
            {
                own++;
            }
            else if (peer.Refusal is null != center.Refusal is null)
            {
                failures.Add($"seed {seed}: {peer.Refusal ?? "accepted"} {center.Refusal?.Message}\n{contour.Iso}\n{contour.Klartext}");
            }
            else if (peer.Refusal is null)
            {
                motions += Compare($"seed {seed}", peer, center, failures);
            }
        }

        TestContext.Current.TestOutputHelper?.WriteLine(
            $"{Contours} contours, {refused} refused by rs274, {wrong} by us only, {own} by a rule of rs274 only, {motions} motions "
                + $"compared, {failures.Count} differ");
        Assert.True(failures.Count == 0, $"{failures.Count} of {Contours} contours differ, first {failures.FirstOrDefault()}");
        Assert.InRange(refused, 0, Contours / 4);
    }

    // LinuxCNC alone stops where an arc gets longer behind a slight outside turn.
    private static bool GrowsArc(string iso) =>
        CompensatedPath.Of(NcInterpreter.Run(NcProgram.FromText(iso, NcSyntax.LinuxCnc), NcDialects.LinuxCnc)).Refusal?.Code
            == NcRefusalCodes.CompensationStop;

    private static int Compare(string contour, PeerRun peer, CompensatedPath center, List<string> failures)
    {
        // Two moves lead to the start. The way in ends differently: on LinuxCNC an outside corner may follow it. The last is the way out.
        var own = center.Motions.Skip(3).SkipLast(1).ToList();
        var theirs = peer.Motions.Skip(3).SkipLast(1).ToList();
        theirs.RemoveRange(0, theirs.Count == own.Count + 1 && theirs[0].Kind != MotionKind.Line ? 1 : 0);
        var count = Math.Min(theirs.Count, own.Count);
        for (var i = 0; i < count; i++)
        {
            var (a, b) = (theirs[i], own[i]);
            var off = Math.Max(Math.Abs(a.End.X - b.End.X), Math.Abs(a.End.Y - b.End.Y));
            off = b.IsArc ? Math.Max(off, Math.Max(Math.Abs(a.Center.X - b.Center.X), Math.Abs(a.Center.Y - b.Center.Y))) : off;
            if (a.Kind != b.Kind || off > ToleranceMm + (a.ResolutionMm / 2))
            {
                failures.Add($"{contour}, motion {i}: {a.Kind} {a.End} {a.Center}, ours {b.Kind} {b.End} {b.Center}");
                return i;
            }
        }

        if (theirs.Count != own.Count)
        {
            failures.Add($"{contour}: rs274 has {theirs.Count} motions, we have {own.Count}");
        }

        return count;
    }
}
