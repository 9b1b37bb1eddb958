using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Testing;
using FsCheck.Fluent;

namespace ErrorMatching.Hmi.Tests;

public sealed class ProgramPictureTests
{
    private const double Small = 1e-9;

    [Fact]
    public async Task What_is_picked_comes_out_in_the_words_of_the_job()
    {
        var picture = new ProgramPicture(Sample());
        var chosen = new List<RangeChoice>();
        picture.RangeChosen += chosen.Add;
        picture.Light(BlockOf(picture, "N160"));
        Assert.False(picture.Take.CanExecute(null));
        picture.Feature = "L2L3";
        picture.Extend(BlockOf(picture, "N130"));
        Assert.Matches(@"^N130 \S+ N160\D+4 \D+$", picture.Chosen);
        picture.Take.Execute(null);
        await picture.Choosing;
        picture.Light(BlockOf(picture, "N120"));
        picture.Take.Execute(null);
        await picture.Choosing;
        Assert.Equal(["L2L3: N130..N160", "L2L3: N120"], chosen.Select(c => $"{c.Feature}: {string.Join(' ', c.Blocks)}"));
        Assert.All(chosen, c => Assert.False(c.IsMore));
    }

    [Fact]
    public async Task Comments_at_the_ends_of_a_range_are_not_part_of_it()
    {
        var picture = new ProgramPicture(Sample()) { Feature = "L1" };
        RangeChoice? chosen = null;
        picture.RangeChosen += c => chosen = c;
        picture.Light(BlockOf(picture, "N120") - 1);
        picture.Extend(BlockOf(picture, "N120") + 1);
        picture.Take.Execute(null);
        await picture.Choosing;
        Assert.Equal(["N120"], chosen!.Blocks);
    }

    [Fact]
    public async Task What_moves_nothing_cannot_be_taken_and_says_so()
    {
        var picture = new ProgramPicture(Sample()) { Feature = "L1" };
        picture.RangeChosen += c => Assert.Fail($"{string.Join(' ', c.Blocks)} cuts nothing.");
        var comment = BlockOf(picture, "N120") - 1;
        picture.Light(comment);
        Assert.False(picture.Take.CanExecute(null) || picture.Add.CanExecute(null));
        Assert.Contains("nothing moves", picture.Chosen, StringComparison.Ordinal);
        picture.Take.Execute(null);
        await picture.Choosing;
        picture.Extend(comment + 1);
        Assert.True(picture.Take.CanExecute(null));
        Assert.DoesNotContain("nothing moves", picture.Chosen, StringComparison.Ordinal);

        // Who does not pick is not told what could not be picked.
        picture.Feature = null;
        picture.Light(comment);
        Assert.DoesNotContain("nothing moves", picture.Chosen, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_second_tap_takes_nothing_though_the_next_feature_is_picked_for()
    {
        var picture = new ProgramPicture(Sample()) { Feature = "L1" };
        var chosen = new List<RangeChoice>();
        picture.RangeChosen += c =>
        {
            chosen.Add(c);
            picture.Feature = "L2L3";
        };
        var block = BlockOf(picture, "N120");
        picture.Light(block);
        picture.Take.Execute(null);
        picture.Take.Execute(null);
        await picture.Choosing;
        Assert.Null(picture.Selection);
        Assert.False(picture.Take.CanExecute(null));
        picture.Take.Execute(null);
        await picture.Choosing;
        Assert.Equal(["L1: N120"], chosen.Select(c => $"{c.Feature}: {string.Join(' ', c.Blocks)}"));

        // What was taken is where the keys go on from.
        picture.Move(1, isExtending: true);
        Assert.Equal(new BlockRange(block + 1, block + 1), picture.Selection);
    }

    [Fact]
    public async Task Features_are_marked_by_the_words_of_the_job_and_a_wrong_one_says_why()
    {
        var picture = new ProgramPicture(Sample());
        await picture.MarkAsync([new("L1", ["N120"]), new("L2L3", ["N130..N160"]), new("X", ["N999"]), new("Y", ["nonsense"])]);
        Assert.Equal("L2L3", picture.FeatureOf(BlockOf(picture, "N140")));
        Assert.Equal("L1", picture.FeatureOf(BlockOf(picture, "N120")));
        Assert.Null(picture.FeatureOf(BlockOf(picture, "N110")));
        Assert.Equal([false, false, true, true], picture.Marks.Select(m => m.Problem is not null));
    }

    [Fact]
    public async Task Whoever_may_not_cannot_pick_and_what_reads_like_another_block_is_named_by_its_line()
    {
        var picture = new ProgramPicture(Open("G1 X1.\nX2.\nX1.\nX2.\n")) { Feature = "A", IsReadOnly = true };
        picture.Light(1);
        Assert.False(picture.Take.CanExecute(null) || picture.IsPicking);
        picture.IsReadOnly = false;
        var chosen = new List<RangeChoice>();
        picture.RangeChosen += chosen.Add;
        picture.Take.Execute(null);
        await picture.Choosing;
        Assert.Equal(["L2"], Assert.Single(chosen).Blocks);
        Assert.Null(picture.Selection);
    }

    [Fact]
    public void The_lit_blocks_grow_from_the_first_one_in_both_directions_and_stay_in_the_program()
    {
        var picture = new ProgramPicture(Sample());
        picture.Light(10);
        picture.Move(3, isExtending: true);
        Assert.Equal(new BlockRange(10, 13), picture.Selection);
        picture.Move(-5, isExtending: true);
        Assert.Equal((new BlockRange(8, 10), 8), (picture.Selection!.Value, picture.Cursor));
        picture.Move(-100, isExtending: false);
        Assert.Equal(new BlockRange(0, 0), picture.Selection);
        picture.Extend(int.MaxValue);
        Assert.Equal(new BlockRange(0, picture.Program.Count - 1), picture.Selection);
    }

    [Fact]
    public void A_motion_lights_its_block()
    {
        var picture = new ProgramPicture(Sample());
        picture.LightMotion(picture.Program.Path.MotionOf(BlockOf(picture, "N140")));
        Assert.Equal("N140", picture.Chosen);
    }

    [Fact]
    public void A_program_of_a_million_blocks_is_opened_and_none_of_its_lines_is_made_into_text()
    {
        var text = new StringBuilder("%\nN10 G21 G17 G90\n");
        for (var i = 2; i < 1_000_000; i++)
        {
            text.Append(System.Globalization.CultureInfo.InvariantCulture, $"N{i * 10} G1 X{i % 1000} Y{i / 1000}\n");
        }

        var program = Open(text.ToString());
        Assert.Equal(1_000_000, program.Count);
        Assert.Equal(new PlotBox(0, 0, 999, 999), program.Moves.Extent);
        Assert.Equal("N9999990 G1 X999 Y999", program.LineAt(999_999));
        Assert.Equal(999_999, program.Path.Motions.BlockOf(program.Moves.Nearest(new(998.9, 999.4), 5)));
        var before = GC.GetAllocatedBytesForCurrentThread();
        _ = program.LineAt(500_000);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 2_000);

        // All of it on a screen of 1000 by 800: not much more strokes than pixels, and what is not seen is not looked at.
        var strokes = new List<MoveStroke>();
        Assert.True(program.Moves.Strokes(PlotView.Fit(program.Moves.Extent, 100, 80, 0, isTrue: true), 1, Keep));
        Assert.InRange(strokes.Count, 1_000, 200_000);
        strokes.Clear();
        Assert.True(program.Moves.Strokes(new(100, 100, new(500.5, 500.5), 100, 80), 1, Keep));
        Assert.InRange(strokes.Count, 1, 40);
        Assert.False(program.Moves.Strokes(new(100, 100, new(500.5, 500.5), 100, 80), 1, _ => false));

        bool Keep(MoveStroke stroke)
        {
            strokes.Add(stroke);
            return true;
        }
    }

    [Fact]
    public void The_nearest_motion_is_that_of_looking_at_all()
    {
        var program = Sample();
        Law.Holds(Gen.Choose(-80_000, 10_000).Zip(Gen.Choose(-30_000, 100_000)), p =>
        {
            var place = new Point2(p.Item1 / 1000.0, p.Item2 / 1000.0);
            var all = Enumerable.Range(0, program.Moves.Count)
                .Where(i => program.Moves.EndsOf(i) is not null)
                .Select(i => program.Moves.NearestOn(i, place).DistanceTo(place))
                .Min();
            return Math.Abs(
                program.Moves.NearestOn(program.Moves.Nearest(place, double.PositiveInfinity), place).DistanceTo(place) - all) < Small;
        });
    }

    [Fact]
    public void Arcs_are_drawn_by_chords_that_lie_within_a_quarter_of_a_pixel_of_them()
    {
        var program = Open("G21 G17 G90\nG0 X10. Y0.\nG3 X-10. Y0. I-10. J0.\nG2 X10. Y0. I10. J0. Z-5.\n");
        var view = PlotView.Fit(program.Moves.Extent, 800, 800, 0, isTrue: true);
        Assert.Equal(new PlotBox(-10, 0, 10, 10), program.Moves.Extent);
        var strokes = program.Moves.StrokesOf(1, view);
        Assert.InRange(strokes.Count, 10, 100);
        Assert.All(
            strokes,
            s => Assert.InRange(
                view.ToPlot(new((s.X1 + s.X2) / 2, (s.Y1 + s.Y2) / 2)).DistanceTo(new(0, 0)), 10 - (0.26 / view.ScaleX), 10.0001));
        Assert.Equal(
            (view.ToScreen(new(10, 0)), view.ToScreen(new(-10, 0))),
            (new(strokes[0].X1, strokes[0].Y1), new(strokes[^1].X2, strokes[^1].Y2)),
            (a, b) => a.Item1.DistanceTo(b.Item1) + a.Item2.DistanceTo(b.Item2) < 0.01);
    }

    [Fact]
    public void The_path_is_seen_against_the_plane_it_is_cut_in_and_unknown_places_are_left_out()
    {
        var program = Open("G21 G18 G90\nG53 G0 X0 Z0\nG1 X5.\nG1 X20. Z30. F100.\nX40. Z10.\n");
        Assert.Equal(CoordinatePlane.ZX, program.Moves.Plane);
        Assert.Equal(new PlotBox(10, 20, 30, 40), program.Moves.Extent);
        Assert.Null(program.Moves.EndsOf(program.Path.MotionOf(2)));
    }

    [Fact]
    public void A_line_as_long_as_a_file_is_shown_in_part_and_a_character_is_not_cut()
    {
        var program = Open("(" + string.Concat(Enumerable.Repeat("測", 1_000_000)) + ")\n");
        Assert.InRange(program.LineAt(0).Length, 100, OpenedProgram.MostShown);
        Assert.DoesNotContain('\u00e6', program.LineAt(0));
        Assert.EndsWith("測…", program.LineAt(0), StringComparison.Ordinal);
    }

    [Fact]
    public void Empty_programs_and_broken_ones_are_opened_too()
    {
        foreach (var text in new[] { "", "%", "\n\n\n", "((((", "G3 X1 I", "GOTO 1\nN1 GOTO 1\n", "\0\u0001\ufffd" })
        {
            var picture = new ProgramPicture(Open(text));
            picture.Light(3);
            picture.Extend(0);
            _ = (picture.Chosen, picture.Message, picture.Program.Moves.Nearest(new(0, 0), 1));
            Assert.True(
                picture.Program.Moves.Strokes(PlotView.Fit(picture.Program.Moves.Extent, 100, 100, 10, isTrue: true), 1, _ => true));
        }
    }

    private static int BlockOf(ProgramPicture picture, string name) =>
        Enumerable.Range(0, picture.Program.Count).First(b => picture.Program.NameOf(b) == name);

    private static OpenedProgram Sample() => OpenedProgram.Read(
        File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc")),
        NcDialects.DeltaNc300,
        TestContext.Current.CancellationToken);

    private static OpenedProgram Open(string text) =>
        OpenedProgram.Read(Encoding.UTF8.GetBytes(text), NcDialects.FanucMill, TestContext.Current.CancellationToken);
}
