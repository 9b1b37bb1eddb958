using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// Random jobs that are corrected by an offset: LinuxCNC's own interpreter runs the program of the offsets and then the unchanged program,
/// and the piece that its tool's center leaves is probed.
/// </summary>
public sealed partial class OffsetCorrectionTests
{
    private const int Jobs = 20;

    // A micrometer, the words of the programs, and the four decimals that the peer prints.
    private const double Within = 0.001 + 0.0015 + 0.0003;

    private const string Line = "G0 X0 Y-5\nG1 F100 G41 D1 X0 Y0\nX10\nX20\nG40 X30 Y-5\n";

    [Fact]
    public void Twenty_jobs_are_cut_where_the_offset_should_bring_them()
    {
        Rs274.IsNeeded();
        var (done, kinds, failures) = (0, new HashSet<CorrectionKind>(), new List<string>());
        for (var seed = 0; done < Jobs; seed++)
        {
            var part = OffsetWay.WithTool(RandomParts.Generate(seed));
            var way = new OffsetWay(part, seed);
            var outcome = Matcher.Match(RandomMatch.Offsets(part, way.Deviation, OffsetWay.Job));
            if (outcome.Result is not { Correction: { IsOffset: true } offset })
            {
                Assert.True(seed < 10 * Jobs, $"only {done} jobs");
                continue;
            }

            done++;
            kinds.Add(offset.Kind!.Value);
            var program = Encoding.ASCII.GetString(offset.Program!);

            // Twice, as after a power cut: the second run must change nothing.
            if ((Problem(part, way, program) ?? Problem(part, way, program, program)) is { } problem)
            {
                failures.Add($"{seed}, {way.Name}, {offset.Kind}: {problem}");
            }
        }

        Assert.True(failures.Count == 0, $"{failures.Count}:\n{string.Join('\n', failures)}");
        Assert.Equal([CorrectionKind.ToolWear, CorrectionKind.WorkOffset], kinds.Order());
    }

    [Fact]
    public void An_offset_that_somebody_changed_stops_the_program()
    {
        Rs274.IsNeeded();
        var once = Program(0.012m, null);
        var after = Rs274.RunWithTools(Text(once, "G10 L1 P1 R0.3\n", Program(0.02m, null)), Tools);
        Assert.Contains("radius-of-tool-1-was-changed-by-hand", after.Refusal, StringComparison.Ordinal);
        Assert.Null(Rs274.RunWithTools(Text(once, Program(0.02m, null)), Tools).Refusal);
    }

    [Fact]
    public void A_correction_that_does_not_follow_the_one_before_stops_the_program()
    {
        Rs274.IsNeeded();
        Assert.Contains(
            "does-not-have-the-correction-before",
            Rs274.RunWithTools(Text(Program(0.012m, null), Program(0.02m, 0.008m)), Tools).Refusal,
            StringComparison.Ordinal);
        Assert.Null(Rs274.RunWithTools(Text(Program(0.012m, null), Program(0.02m, 0.012m)), Tools).Refusal);

        // Run again after it did its work.
        Assert.Null(Rs274.RunWithTools(Text(Program(0.012m, null), Program(0.02m, 0.012m), Program(0.02m, 0.012m)), Tools).Refusal);
    }

    [Fact]
    public void A_step_beyond_the_limit_stops_the_program()
    {
        Rs274.IsNeeded();
        Assert.Contains(
            "would-change-by-more-than-a-step",
            Rs274.RunWithTools(Text(Program(0.03m, null), Program(-0.03m, null)), Tools).Refusal,
            StringComparison.Ordinal);
    }

    [Fact]
    public void An_offset_without_a_correction_may_be_changed_by_hand()
    {
        Rs274.IsNeeded();
        // The path of the tool's center shows the radius: 0.3 and the correction.
        var byHand = "G10 L1 P1 R0.3\n";
        var path = Rs274.RunWithTools(
            Text(Program(0.012m, null), Program(0m, null), byHand, Program(0.02m, null), Line), Tools);
        Assert.Contains(path.Motions, m => Math.Abs(m.End.Y - 0.32) < 1e-4);
    }

    [Fact]
    public void Units_and_increments_of_the_machine_stay_as_they_were()
    {
        Rs274.IsNeeded();
        var run = Rs274.RunWithTools("G20 G91 G54\nT1 M6\n" + Text(Program(0.012m, null), "G1 F10 X1\nX1\n").Split("T1 M6\n")[1], Tools);
        Assert.Null(run.Refusal);
        Assert.InRange(run.Motions[^1].End.X, 50.799, 50.801);
    }

    // Stopped anywhere, and run again: each line may be the last one of the first run.
    [Fact]
    public void The_program_may_be_stopped_anywhere_and_run_again()
    {
        Rs274.IsNeeded();
        var lines = Program(0.02m, null).Split('\n').Where(IsKept).ToArray();
        var (runs, inBlock) = (0, 0);
        for (var stop = 1; stop <= lines.Length; stop++)
        {
            inBlock += lines[stop - 1].Contains(" if ", StringComparison.Ordinal) ? 1 : 0;
            inBlock -= lines[stop - 1].EndsWith("endif", StringComparison.Ordinal) ? 1 : 0;
            if (inBlock > 0)
            {
                continue;
            }

            runs++;
            var cut = string.Concat(lines.Take(stop).Select(l => l + "\n"));
            var path = Rs274.RunWithTools(
                Text(Program(0.012m, null), cut, Program(0.02m, null), Line), Tools);
            Assert.True(path.Refusal is null, $"stopped behind {lines[stop - 1]}: {path.Refusal}");
            Assert.Contains(path.Motions, m => Math.Abs(m.End.Y - 0.22) < 1e-4);
        }

        Assert.InRange(runs, 10, 40);
    }

    // The file as it is written, called by a program that uses the same labels, variables and modes.
    [Theory]
    [InlineData("tool")]
    [InlineData("work")]
    public void A_program_that_calls_the_offsets_goes_on_behind_the_call(string corrects)
    {
        Rs274.IsNeeded();
        var program = corrects == "tool" ? Program(0.02m, null) : Encoding.ASCII.GetString(OffsetProgram.Write(
            NcDialects.LinuxCnc, null, new(1, new(0, -0.02m, 0), null), OffsetLimits.Default, 501, 9001, "offsets.ngc"));
        var call = OffsetProgram.CallOf(NcDialects.LinuxCnc, "offsets.ngc", 9001);
        Assert.Equal("o<offsets> call", call);
        var folder = Directory.CreateTempSubdirectory("errormatch-offsets-").FullName;
        try
        {
            File.WriteAllText(Path.Combine(folder, "offsets.ngc"), program);
            var run = Rs274.RunWithTools(
                $"G21 G17 G40 G91 G54\nT1 M6\n#<now>=7\n{call}\no100 if [#<now> EQ 7]\n(LOG,behind)\no100 endif\nG1 F100 X1\n"
                    + $"G90\n{Line}M2\n",
                Tools,
                folder);
            Assert.Null(run.Refusal);
            Assert.Equal(["behind"], run.Log);
            Assert.Contains(run.Motions, m => Math.Abs(m.End.Y + run.Origin.Y - (corrects == "tool" ? 0.22 : 0.18)) < 1e-4);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void The_offsets_run_by_themselves_as_well()
    {
        Rs274.IsNeeded();
        var work = Encoding.ASCII.GetString(OffsetProgram.Write(
            NcDialects.LinuxCnc, null, new(1, new(0.01m, -0.02m, 0), null), OffsetLimits.Default, 501, 9001, "Boss Offsets.ngc"));
        var run = Rs274.RunWithTools(work, Tools);
        Assert.Null(run.Refusal);
        Assert.Equal((0.01, -0.02), (Math.Round(run.Origin.X, 4), Math.Round(run.Origin.Y, 4)));
    }

    private static string Program(decimal total, decimal? before) => Encoding.ASCII.GetString(OffsetProgram.Write(
        NcDialects.Named("linuxcnc"), new(1, 1, total, before), null, OffsetLimits.Default, 501, 9001, "offsets.ngc"));

    private static string? Problem(RandomPart part, OffsetWay way, params string[] offsets)
    {
        var (with, without) = (Rs274.RunWithTools(Text([.. offsets, part.Program]), Tools), Rs274.RunWithTools(Text(part.Program), Tools));
        if ((with.Refusal ?? without.Refusal) is { } refusal)
        {
            return refusal;
        }

        var (cut, nominal) = (Cut(with, part.ToolRadius), Cut(without, part.ToolRadius));
        var (sin, cos) = Math.SinCos(with.Origin.Rotation * Math.PI / 180);
        foreach (var point in part.KeyPoints)
        {
            // The peer prints places in the work offset: what is cut at a place is turned, then shifted.
            var at = point.Place - new Flat(with.Origin.X, with.Origin.Y);
            var error = cut.Probe(Back(at), Back(point.Normal)) - nominal.Probe(point.Place, point.Normal) - way.Deviation(point);
            if (!(Math.Abs(error) <= Within))
            {
                return string.Create(
                    CultureInfo.InvariantCulture, $"{error:0.0000} mm left at {point.Label} (deviation {way.Deviation(point):0.0000})");
            }
        }

        return null;

        Flat Back(Flat v) => new((cos * v.U) + (sin * v.V), (cos * v.V) - (sin * v.U));
    }

    // 0.4 mm in inches.
    private static string Tools => $"T1 P1 D{(0.4 / 25.4).ToString("R", CultureInfo.InvariantCulture)} ;mill\n";

    // One program: without what begins and ends a file of its own, with labels of its own for each part, and with the tool in the spindle
    // from the beginning.
    private static string Text(params string[] programs) => "G21 G17 G40 G90 G54\nT1 M6\n" + string.Concat(
        programs.SelectMany((p, i) => p.Split('\n').Where(IsKept).Select(
            l => Label().Replace(l, m => $"o{i.ToString(CultureInfo.InvariantCulture)}{m.Groups["number"].Value} ") + "\n"))) + "M2\n";

    private static bool IsKept(string line) =>
        line.Length > 0 && line[0] is not ('%' or 'O') && line is not ("M2" or "T1 M6")
            && !line.StartsWith("o<offsets> ", StringComparison.Ordinal);

    [GeneratedRegex("^o(?<number>[0-9]{1,5}) ", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Label();

    private static VirtualCut Cut(PeerRun run, double toolRadius)
    {
        var (moves, at) = (new List<RefereeMove>(), default(Spot));
        foreach (var motion in run.Motions)
        {
            var to = new Spot(motion.End.X, motion.End.Y, motion.End.Z);
            var move = new RefereeMove("", 0, motion.Kind == MotionKind.Rapid, at, to, WorkPlane.XY, CutterSide.None);
            moves.Add(motion.Kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise
                ? move.Around(new(motion.Center.X, motion.Center.Y), motion.Kind == MotionKind.ArcCounterClockwise)
                : move);
            at = to;
        }

        return new(moves, toolRadius);
    }
}
