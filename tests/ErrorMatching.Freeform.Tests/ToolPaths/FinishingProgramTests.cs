using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The program, read back by the interpreter of NC programs.</summary>
public sealed class FinishingProgramTests
{
    public static TheoryData<string> Dialects => [.. NcDialects.All.Where(d => d.HasCodes).Select(d => d.Name)];

    [Theory]
    [MemberData(nameof(Dialects))]
    public void Each_control_s_program_is_understood_and_makes_the_moves_of_the_path(string name)
    {
        var dialect = NcDialects.Named(name);
        var toolpath = Plans.Passes(0.02, 0.01, zigzag: false);
        var path = Plans.Path(Shapes.Three, toolpath, dialect: dialect);
        var bytes = FinishingProgram.Write(path, Plans.Job(toolpath, name), dialect);

        var read = NcInterpreter.Run(NcProgram.Read(bytes), dialect);
        Assert.Null(read.Refusal);
        Assert.Empty(Plans.Faults(read));
        var moves = path.Moves().ToList();
        var offset = read.Motions.Length - moves.Count;
        Assert.Equal(1, offset);
        for (var i = 0; i < moves.Count; i++)
        {
            var motion = read.Motions[i + offset];
            Assert.True((motion.End - moves[i].Center).Length < 1e-9, $"{motion.End} for {moves[i]}");
            Assert.Equal(moves[i].IsRapid, motion.Kind == MotionKind.Rapid);
            Assert.True(moves[i].IsRapid || motion.Feed == 1200);
        }
    }

    // One way, so that each pass has its own: in beside or above its first point, out beside or above its last one,
    // and across only in the air.
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Leads_and_rapids_keep_clear_of_the_part(int design)
    {
        var surface = Shapes.Design(design);
        var path = Plans.Path(surface, Plans.Passes(0.05, 0.02, zigzag: false));
        var moves = path.Moves().ToList();
        Assert.True(moves.Count(m => m.IsRapid) >= 2 * path.Passes);
        for (var i = 1; i < moves.Count; i++)
        {
            var (from, to) = (moves[i - 1].Center, moves[i].Center);
            var isLead = !moves[i].IsRapid && (moves[i - 1].IsRapid || i + 1 == moves.Count || moves[i + 1].IsRapid);
            if (!moves[i].IsRapid && !isLead)
            {
                continue;
            }

            // Ends of leads touch the surface; nothing comes nearer than touching, up to rounding.
            for (var k = 0; k <= 10; k++)
            {
                var nearest = surface.Spline.ClosestPoint(from + ((to - from) * (k / 10.0))).Distance;
                Assert.True(
                    nearest > 3 - 0.001 && (k is 0 or 10 || !moves[i].IsRapid || nearest > 3.1),
                    $"{i}: {nearest} mm at {k} tenths from {from} to {to}");
            }
        }
    }

    [Fact]
    public void The_tip_runs_a_radius_below_the_center()
    {
        var (center, tip) = (Plans.Passes(0.02, 0.01), Plans.Passes(0.02, 0.01, tip: true));
        var path = Plans.Path(Shapes.One, tip);
        var program = NcInterpreter.Run(
            NcProgram.Read(FinishingProgram.Write(path, Plans.Job(tip, "linuxcnc"), NcDialects.LinuxCnc)), NcDialects.LinuxCnc);

        var moves = path.Moves().ToList();
        Assert.Equal(moves[5].Center.Z - 3, program.Motions[6].End.Z, 1e-9);
        Assert.Equal(Plans.Path(Shapes.One, center).Points, path.Points);
    }

    [Fact]
    public void Words_are_written_where_they_change()
    {
        var toolpath = Plans.Passes(0.05, 0.01);
        var text = Encoding.ASCII.GetString(FinishingProgram.Write(
            Plans.Path(Shapes.Plane(10, 1, 2), toolpath), Plans.Job(toolpath, "linuxcnc"), NcDialects.LinuxCnc));

        Assert.Contains(
            "S10000 M3\nG0 Z15.0000\nX0.0000 Y0.0000\nZ8.0000\nG1Z5.0000 F1200\nX".Replace("G1Z", "G1 Z", StringComparison.Ordinal),
            text,
            StringComparison.Ordinal);
        Assert.EndsWith("\nG0 Z15.0000\nM5\nM2\n", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Writing_keeps_nothing_of_what_is_written()
    {
        var toolpath = Plans.Passes();
        var (path, job) = (Plans.Path(Shapes.One, toolpath), Plans.Job(toolpath, "linuxcnc"));
        using var file = new MemoryStream(8_000_000);
        Write();
        file.SetLength(0);
        var before = GC.GetAllocatedBytesForCurrentThread();
        Write();
        var kept = GC.GetAllocatedBytesForCurrentThread() - before;
        Assert.True(file.Length > 500_000 && kept < file.Length / 4, $"{kept} bytes for {file.Length}");

        void Write() => FinishingProgram.Write(path, job, NcDialects.LinuxCnc, CuttingStage.Finishing, file);
    }

    [Fact]
    public void Words_of_the_job_cannot_end_a_comment()
    {
        var toolpath = Plans.Passes(0.05, 0.01);
        var dialect = NcDialects.FanucMill;
        var bytes = FinishingProgram.Write(
            Plans.Path(Shapes.Plane(10, 1), toolpath, dialect: dialect),
            Plans.Job(toolpath, "fanuc", "Wing) G0 X1000 (\\n%"),
            dialect,
            CuttingStage.Roughing);

        var read = NcInterpreter.Run(NcProgram.Read(bytes), dialect);
        Assert.Empty(Plans.Faults(read));
        Assert.DoesNotContain(Enumerable.Range(0, read.Motions.Length).Select(i => read.Motions[i].End.X), x => x > 100);
        Assert.Contains("(ROUGHING, ", Encoding.ASCII.GetString(bytes), StringComparison.Ordinal);
    }

    // What reads a job refuses such numbers; a job that was made otherwise comes here.
    [Theory]
    [InlineData(0.4, 1200, "spindleRpm of 0.4 would be written as 0; at least 1 is expected")]
    [InlineData(10_000, 0.0004, "feedMmPerMin of 0.0004 would be written as 0; at least 0.001 is expected")]
    public void A_word_that_would_round_to_zero_is_not_written(double speed, double feed, string problem)
    {
        var toolpath = Plans.Passes(0.05, 0.01);
        var job = Plans.Job(toolpath, "linuxcnc") with { Tool = new(6, 2, speed, feed) };
        var error = Assert.Throws<InputException>(() => FinishingProgram.Write(
            Plans.Path(Shapes.Plane(10, 1), toolpath), job, NcDialects.LinuxCnc));
        Assert.Equal(("rounds-to-zero", "job.json", problem), (error.Code, error.File, error.Problem));
    }

    [Fact]
    public void A_control_with_another_increment_than_planned_for_is_an_error() => Assert.Throws<ArgumentException>(() =>
        FinishingProgram.Write(
            Plans.Path(Shapes.Plane(10, 1), Plans.Passes(0.05, 0.01)), Plans.Job(Plans.Passes(), "fanuc"), NcDialects.FanucMill));

    [Theory]
    [InlineData("siemens-840d", 0)]
    [InlineData("fanuc", 2)]
    [InlineData("delta-nc300", 2)]
    [InlineData("generic", 0)]
    [InlineData("linuxcnc", 0)]
    public void A_program_that_follows_a_measurement_says_so_where_its_control_still_finds_what_it_looks_for(string name, int line)
    {
        var (dialect, toolpath) = (NcDialects.Named(name), Plans.Passes(0.05, 0.01));
        var (path, job, marker) = (
            Plans.Path(Shapes.Plane(10, 1), toolpath, dialect: dialect), Plans.Job(toolpath, name), new Marker(new('a', 64), new('b', 64)));
        var bytes = FinishingProgram.Write(path, job, dialect, marker: marker);
        var program = NcProgram.Read(bytes, dialect.Syntax);
        Assert.Equal([(line, marker)], Marker.Find(program));
        Assert.Empty(Plans.Faults(NcInterpreter.Run(program, dialect)));

        // Besides that line it is the program that follows none.
        var lines = Encoding.ASCII.GetString(bytes).Split('\n').ToList();
        lines.RemoveAt(line);
        Assert.Equal(Encoding.ASCII.GetString(FinishingProgram.Write(path, job, dialect)), string.Join('\n', lines));
    }

    [Fact]
    public void Numbers_of_every_size_are_written_exactly()
    {
        foreach (var z in (double[])[0, 0.0001, -0.0001, 9.9999, 10, -10, 99.9999, 123456.789, -0.5])
        {
            using var stream = new MemoryStream();
            var writer = new MoveWriter(stream, 4, 0, "F1"u8.ToArray(), 1e6);
            writer.Write(new(new(z, 1, 2), true));
            writer.Flush();

            Assert.Equal(FormattableString.Invariant($"X{z:0.0000} Y1.0000 Z2.0000\n"), Encoding.ASCII.GetString(stream.ToArray()));
        }
    }
}
