using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// The path of the tool's center under G41 and G42, motion by motion against LinuxCNC's own interpreter, which prints it.
/// <c>ERRORMATCH_COMPENSATED_PROGRAMS</c> sets how many random programs (60 if not set).
/// </summary>
public sealed partial class CompensatedProgramTests
{
    private const double ToleranceMm = 0.0015;

    private const string Setting = "ERRORMATCH_COMPENSATED_PROGRAMS";

    private static readonly int Programs =
        Environment.GetEnvironmentVariable(Setting) is { } text ? int.Parse(text, CultureInfo.InvariantCulture) : 60;

    [Fact]
    public void The_path_of_the_center_is_that_of_rs274()
    {
        Rs274.IsNeeded();
        var (differences, refused, warned, ours) = (new List<string>(), 0, 0, new List<string>());
        for (var seed = 1; seed <= Programs; seed++)
        {
            var contour = new CompensatedContour(seed);
            var peer = Rs274.Run(contour.Text);
            var center = CompensatedPath.Of(Read(contour.Text), TestContext.Current.CancellationToken);
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
            $"{Programs} programs, {refused} refused by rs274, {warned} by us only, {ours.Count} of these without a reason, "
                + $"{differences.Count} differ");
        Assert.True(differences.Count == 0, $"{differences.Count} of {Programs} programs differ, first {differences.FirstOrDefault()}");
        Assert.True(ours.Count == 0, $"{ours.Count} of {Programs} programs are refused without a reason, first {ours.FirstOrDefault()}");
    }

    [Fact]
    public void A_displaced_contour_is_cut_where_it_was_wanted_or_refused()
    {
        Rs274.IsNeeded();
        var (cut, refused, other, wrong) = (0, 0, 0, new List<string>());
        for (var seed = 1; seed <= Programs; seed++)
        {
            var contour = new CompensatedContour(seed);
            var path = Read(contour.Text);
            var random = new Random(seed);
            var first = random.Next(contour.Elements.Count);
            var blocks = contour.Elements.Skip(first).Take(1 + random.Next(4)).ToArray();
            var left = Math.Round(random.Next(4) == 0 ? 2 * Signed(random) : 0.2 * Signed(random), 3);
            var wish = DisplacementWish.Normal(path, blocks, left);
            var rewrite = wish.IsUsable ? Rewriter.Apply(path, wish.Result) : wish.Refusal;
            if (rewrite.IsUsable
                && Prover.Check(path, rewrite.Result.Program, wish.Result!, rewrite.Result.LeastIncrementMm).Holds)
            {
                cut++;
                var problem = Judge(path, wish.Result!, rewrite.Result, left);
                wrong.AddRange(problem is null ? [] : [$"seed {seed}: {problem}\n{contour.Text}\n{Text(rewrite.Result.Program)}"]);
            }
            else if (rewrite.Refusal is { } stop && CompensatedPath.Check(path) is null && CompensatedPath.Stops(stop))
            {
                refused++;
                var problem = JudgeRefusal(contour.Text, blocks, left);
                wrong.AddRange(problem is null ? [] : [$"seed {seed}: {problem} {stop.Message}\n{contour.Text}"]);
            }
            else
            {
                other++;
            }
        }

        TestContext.Current.TestOutputHelper?.WriteLine(
            $"{Programs} programs, {cut} displaced, {refused} refused since the control would stop, {other} for another reason, "
                + $"{wrong.Count} wrong");
        Assert.True(wrong.Count == 0, $"{wrong.Count} of {Programs} programs are wrong, first {wrong.FirstOrDefault()}");
        Assert.True(cut > Programs / 4, $"Only {cut} of {Programs} programs are displaced.");
    }

    // Null where rs274 leads the tool's center along the named elements by the radius and the displacement beside the original ones.
    private static string? Judge(NcPath path, DisplacementWish wish, Rewrite rewrite, double left)
    {
        var (peer, center) = (Rs274.Run(Text(rewrite.Program)), CompensatedPath.Of(Read(Text(rewrite.Program))));
        if (peer.Refusal is not null || center.Refusal is not null || FirstDifference(peer, center) is not null)
        {
            return $"{peer.Refusal} {center.Refusal?.Message} {FirstDifference(peer, center)}";
        }

        var radius = ToolRadius(path);
        foreach (var element in wish.Elements)
        {
            var was = path.Motions[element.Motion];
            if (!center.Path.Motions[element.Motion].MovesInPlane)
            {
                // A corner cut the short element off.
                continue;
            }

            var index = center.Motions.ToList().FindIndex(m => m.Motion == element.Motion && !m.IsInserted);
            var (from, to) = (was.Plane.Project(peer.Motions[index - 1].End), was.Plane.Project(peer.Motions[index].End));
            var wanted = left + (was.Has(MotionFlags.CompensationLeft) ? radius : -radius);
            var off = Math.Max(was.IsArc ? 0 : Math.Abs(Beside(was, from) - wanted), Math.Abs(Beside(was, to) - wanted));

            // A near tangent moves the start of the next element: what is no corner to the control is cut as one straight piece.
            var straightens = 0.0013 * radius;
            if (off > ToleranceMm + peer.Motions[index].ResolutionMm + straightens && was.PlaneLength > 0.5)
            {
                return FormattableString.Invariant($"line {was.Block + 1} is cut {off} mm beside the wanted place");
            }
        }

        return null;
    }

    private static double Beside(in NcMotion was, Point2 place) => !was.IsArc
        ? was.Segment.Line.SignedDistance(place)
        : (was.Center.DistanceTo(was.PlaneEnd) - was.Center.DistanceTo(place)) * (was.Kind == MotionKind.ArcCounterClockwise ? 1 : -1);

    // Null where rs274 refuses the program that would have been written, or would cut something else. The same program is displaced with
    // a radius from a table that nobody stated, so that nothing is known about the tool.
    private static string? JudgeRefusal(string text, int[] blocks, double left)
    {
        var radius = Compensation().Match(text);
        var path = Read(Compensation().Replace(text, m => m.Groups["code"].Value + " D7"));
        var wish = DisplacementWish.Normal(path, blocks, left);
        var rewrite = Rewriter.Apply(path, wish.Result!);
        if (!rewrite.IsUsable)
        {
            return rewrite.Refusal.Code == "compensation-entry" ? null : $"another refusal: {rewrite.Refusal.Message}";
        }

        var result = Text(rewrite.Result.Program).Replace(" D7", ".1" + radius.Groups["d"].Value, StringComparison.Ordinal);
        var (peer, center) = (Rs274.Run(result), CompensatedPath.Of(Read(result)));
        return peer.Refusal is null && !CutsWrong(peer, center) ? "rs274 accepts it" : null;
    }

    private static double ToolRadius(NcPath path)
    {
        var text = Text(path.Program);
        var diameter = double.Parse(Compensation().Match(text).Groups["d"].Value.Trim()[1..], CultureInfo.InvariantCulture);
        return diameter / 2 * (text.StartsWith("N1 G20", StringComparison.Ordinal) ? 25.4 : 1);
    }

    private static double Signed(Random random) => (2 * random.NextDouble()) - 1;

    private static NcPath Read(string text) => NcInterpreter.Run(NcProgram.FromText(text, NcSyntax.LinuxCnc), NcDialects.LinuxCnc);

    private static string Text(NcProgram program) => System.Text.Encoding.Latin1.GetString(program.Bytes.Span);

    [GeneratedRegex(@"(?<code>G4[12])\.1(?<d> D[0-9.]+)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Compensation();

    /// <summary>True for a program that rs274 accepts although the tool would cut something else: at the element that we refuse, its own
    /// path goes backwards on a line, is on the wrong side of an arc's center, or goes along an arc by half a turn more or less than
    /// programmed.</summary>
    internal static bool CutsWrong(PeerRun peer, CompensatedPath ours)
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
                return string.Create(
                    CultureInfo.InvariantCulture,
                    $"motion {i}, {wrong}: N{theirs.Line} {theirs.Kind} to {theirs.End} about {theirs.Center} turns {theirs.Turns}, ours "
                        + $"N{line} {own.Kind} to {own.End} about {own.Center} turns {own.Turns} {peer.Refusal} {ours.Refusal}");
            }
        }

        return peer.Refusal is not null && ours.Refusal is null ? $"only rs274 refuses it: {peer.Refusal}"
            : peer.Refusal is null && ours.Refusal is null && peer.Motions.Count != ours.Motions.Count
                ? $"rs274 has {peer.Motions.Count} motions, we have {ours.Motions.Count}"
            : null;
    }
}
