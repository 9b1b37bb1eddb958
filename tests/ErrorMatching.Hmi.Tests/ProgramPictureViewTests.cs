using System.Text;
using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Geometry;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What pointer, fingers and keys do to a program's text and path.</summary>
public sealed class ProgramPictureViewTests
{
    [Fact]
    public Task A_tapped_block_lights_its_move_and_a_tapped_move_its_block() => At(Sample(), view =>
    {
        view.Tap(view.RowOf("N140"));
        Assert.Equal("N140", view.Picture.Chosen);
        Assert.True(view.IsLit(view.MiddleOf("N140")), "The move is not lit.");
        Assert.False(view.IsLit(view.MiddleOf("N120")), "Another move is lit.");

        view.User.Click(view.Path, view.MiddleOf("N1000"));
        Assert.Equal("N1000", view.Picture.Chosen);
        Assert.InRange(view.RowOf("N1000").Y, 0, view.Text.Bounds.Height);
        Assert.StartsWith("N1000\n", view.Path.Values, StringComparison.Ordinal);
        Assert.True(view.IsLit(view.MiddleOf("N1000")));
    });

    [Fact]
    public Task Dragging_picks_a_range_by_mouse_over_the_text_and_by_finger_over_the_numbers() => At(Sample(), view =>
    {
        view.User.Drag(view.Text, view.RowOf("N130"), view.RowOf("N160"));
        Assert.Equal("N130 to N160: 4 lines", view.Picture.Chosen);
        view.User.Swipe(view.Text, view.RowOf("N150").WithX(20), view.RowOf("N110").WithX(20));
        Assert.Equal("N110 to N150: 7 lines", view.Picture.Chosen);
        Assert.Equal(0, view.Text.Offset.Y);
    });

    [Fact]
    public Task A_finger_over_the_text_scrolls_it_and_lights_a_block_when_it_is_lifted_at_once() => At(Sample(), view =>
    {
        view.User.Swipe(view.Text, view.RowOf("N140"), view.RowOf("N60"));
        Assert.Null(view.Picture.Selection);
        Assert.True(view.Text.Offset.Y > 0);
        view.Text.Offset = default;
        view.User.Tap(view.Text);
        Assert.Equal(1, view.Picture.Selection!.Value.Count);
    });

    [Fact]
    public Task A_drag_beyond_the_border_goes_on_picking() => At(Sample(), view =>
    {
        view.User.Drag(view.Text, view.RowOf("N60"), new(100, view.Text.Bounds.Height + 200));
        Assert.True(view.Text.Offset.Y > 0);
        Assert.True(view.Picture.Cursor * view.Text.RowHeight > view.Text.Bounds.Height);
    });

    [Fact]
    public Task Keys_light_blocks_and_with_shift_ranges() => At(Sample(), view =>
    {
        view.Tap(view.RowOf("N120"));
        view.User.Press(Key.Down).Press(Key.Down);
        Assert.Equal("N130", view.Picture.Chosen);
        view.User.Press(Key.Down, RawInputModifiers.Shift)
            .Press(Key.Down, RawInputModifiers.Shift)
            .Press(Key.Down, RawInputModifiers.Shift);
        Assert.Equal("N130 to N160: 4 lines", view.Picture.Chosen);
        view.User.Press(Key.End);
        Assert.Equal(view.Picture.Program.Count - 1, view.Picture.Cursor);
        Assert.True(view.Text.Offset.Y > 0);
        view.User.Press(Key.Home).Press(Key.PageDown);
        Assert.InRange(view.Picture.Cursor, 5, 30);
    });

    [Fact]
    public async Task What_is_picked_by_buttons_is_told_and_marked() => await At(Sample(), async view =>
    {
        var choices = new List<RangeChoice>();
        view.Picture.RangeChosen += choices.Add;
        Assert.Null(view.Find("program-take"));
        view.Picture.Feature = "L2L3";
        view.User.Settle();
        view.User.Drag(view.Text, view.RowOf("N130"), view.RowOf("N160"));
        view.User.Click(view.Find("program-take")!).Click(view.Find("program-take")!);
        await view.Picture.Choosing;
        var chosen = Assert.Single(choices);
        Assert.Equal(["N130..N160"], chosen.Blocks);
        await view.Picture.MarkAsync([new("L1", ["N120"]), new("L2L3", chosen.Blocks), new("C1", ["N170..N1190"])]);
        view.User.Click(view.Find("program-behind")!);
        Assert.Equal("line 25 · nothing moves here", view.Picture.Chosen);
        view.User.Screenshot(Repository.PathTo("artifacts", "screenshots", "program-picture-light-en-1280x1000.png"));
    });

    [Fact]
    public Task A_move_that_is_not_seen_is_brought_into_view() => At(Sample(), view =>
    {
        view.Path.Zoom(200, new(10, 10));
        var seen = view.Path.View.Seen;
        view.Tap(view.RowOf("N120"));
        Assert.NotEqual(seen, view.Path.View.Seen);
        var (from, to) = view.Picture.Program.Moves.EndsOf(view.Picture.Program.Path.MotionOf(view.Picture.Cursor))!.Value;
        Assert.True(PlotBox.Empty.With(from).With(to).Touches(view.Path.View.Seen));
    });

    [Fact]
    public Task Of_a_million_blocks_only_those_rows_are_made_that_are_seen() => At(Million(), view =>
    {
        Assert.True(view.Path.IsByPixel);
        view.User.WaitFor(() => view.Path.Painting.IsCompleted, Seat.Patience);
        Assert.True(view.HasInk(view.Path.View.At(new(500, 500))), "The path is not drawn.");
        view.Tap(new(200, 20));
        view.User.Press(Key.End);
        Assert.Equal(999_999, view.Picture.Cursor);
        Assert.True(view.IsLit(view.Path.View.At(new(999, 999))), "The last move is not lit.");
        for (var i = 0; i < 50; i++)
        {
            view.User.Press(Key.PageUp);
        }

        Assert.InRange(view.Text.RowsMade, 10, 5 * (int)(view.Text.Bounds.Height / view.Text.RowHeight));
        view.User.Click(view.Path, view.Path.View.At(new(500, 500)));
        Assert.InRange(view.Picture.Cursor, 400_000, 600_000);
    });

    [Fact]
    public async Task A_line_that_does_not_fit_ends_in_an_ellipsis_and_is_shown_whole_when_it_is_lit() =>
        await At(Read($"N10 G1 X1.\nN20 ({new string('X', 200)})\nN30 X2. ({new string('X', 70)})\nN40 X3.\n"), async view =>
    {
        Assert.Equal([1], view.Text.RowsCut);
        Assert.True(view.EndsInDots("N20"), "The cut line looks whole.");
        Assert.False(view.EndsInDots("N30"), "The whole line looks cut.");
        var top = view.Text.TranslatePoint(default, view.Window);
        view.Tap(view.RowOf("N20"));
        Assert.Equal(top, view.Text.TranslatePoint(default, view.Window));
        view.Tap(view.RowOf("N30"));
        Assert.Equal($"N30 X2. ({new string('X', 70)})", ((TextBlock)view.Find("program-line")!).Text);
        view.User.Press(Key.Down);
        Assert.Equal("N40 X3.", ((TextBlock)view.Find("program-line")!).Text);

        // Names of features beside the lines leave less room for them.
        await view.Picture.MarkAsync([new("Flank 12", ["N40"])]);
        view.User.Settle();
        Assert.Equal([1, 2], view.Text.RowsCut);
        Assert.True(view.EndsInDots("N30"), "The cut line looks whole.");
    });

    [Fact]
    public Task What_does_not_fit_is_scrolled_to_by_keys_and_finger_and_the_line_numbers_stay() =>
        At(Read($"N10 G1 X1.\nN20 ({new string('X', 200)})\nN30 X3.\n"), view =>
    {
        view.Tap(view.RowOf("N20"));
        view.User.Press(Key.Right);
        Assert.InRange(view.Text.Offset.X, 1, view.Text.Bounds.Width);
        for (var i = 0; i < 20; i++)
        {
            view.User.Press(Key.Right);
        }

        Assert.Empty(view.Text.RowsCut);
        Assert.Equal("N20", view.Picture.Chosen);
        Assert.True(view.HasNumber("N30"), "The line number went along.");
        Assert.InRange(view.Text.RowsEnd.Single(r => r.Block == 2).End, 0, view.Text.Gutter);
        for (var i = 0; i < 20; i++)
        {
            view.User.Press(Key.Left);
        }

        Assert.Equal(0, view.Text.Offset.X);
        Assert.Equal([1], view.Text.RowsCut);
        view.User.Swipe(view.Text, new(500, 60), new(200, 60));
        Assert.True(view.Text.Offset.X > 0);
        Assert.Equal("N20", view.Picture.Chosen);
    });

    [Fact]
    public async Task It_begins_at_the_blocks_of_the_feature_that_is_picked_for() => await At(Sample(), async view =>
    {
        view.Picture.Feature = "C1";
        await view.Picture.MarkAsync([new("C1", ["N900..N1190"]), new("L1", ["N60"])]);
        view.User.Settle();
        Assert.InRange(view.RowOf("N900").Y, 0, view.Text.Bounds.Height);

        // Whoever looks elsewhere stays there, until another feature is picked for.
        view.Text.Offset = default;
        await view.Picture.MarkAsync([new("C1", ["N900..N1180"]), new("L1", ["N60"])]);
        view.User.Settle();
        Assert.Equal(0, view.Text.Offset.Y);
        view.Text.Offset = new(0, 1000);
        view.Picture.Feature = "L1";
        Assert.InRange(view.RowOf("N60").Y, 0, view.Text.Bounds.Height);
    });

    [Fact]
    public async Task What_is_brought_into_view_begins_with_a_whole_line() => await At(Sample(), async view =>
    {
        double Cut() => Math.Abs(Math.IEEERemainder(view.Text.Offset.Y, view.Text.RowHeight));
        view.Picture.Light(60);
        view.User.Settle();
        Assert.True(view.Text.Offset.Y > 0);
        Assert.Equal(0, Cut(), 1e-6);

        // By as little as it takes, which leaves none of the lit line below the edge.
        var lit = 60;
        while (view.Text.Offset.Y + view.Text.Bounds.Height > (lit + 1) * view.Text.RowHeight)
        {
            lit++;
        }

        view.Picture.Light(lit);
        view.User.Settle();
        Assert.Equal(0, Cut(), 1e-6);
        Assert.True(
            view.Text.Offset.Y + view.Text.Bounds.Height >= (lit + 1) * view.Text.RowHeight, "Part of the lit line is below the edge.");
        view.Picture.Feature = "C1";
        await view.Picture.MarkAsync([new("C1", ["N900..N1190"])]);
        view.User.Settle();
        Assert.Equal(0, Cut(), 1e-6);
    });

    [Fact]
    public Task Key_points_are_drawn_where_they_lie_in_the_program_and_those_that_blocks_are_picked_for_stand_out() => At(Sample(), view =>
    {
        var (point, other) = (new Point2(-31.95, 70), new Point2(-36.62, 19.803));
        Assert.False(view.HasInk(view.Path.View.At(point)));
        view.Picture.Feature = "L1";
        view.Picture.Points = [new("L1", "1", CoordinatePlane.XY, point), new("C1", "8", CoordinatePlane.XY, other)];
        view.User.Settle();
        Assert.True(view.Path.ShowsAll);
        Assert.True(view.HasInk(view.Path.View.At(point)), "The point is not drawn.");
        Assert.False(view.HasInk(view.Path.View.At(other)), "The other one stands out.");
        view.Picture.Feature = "C1";
        view.User.Settle();
        Assert.True(view.HasInk(view.Path.View.At(other)), "The other one is not drawn.");
        Assert.False(view.HasInk(view.Path.View.At(point)), "It stands out still.");

        // What lies elsewhere is no reason to see the path small.
        var scale = view.Path.View.ScaleX;
        view.Picture.Points = [new("L1", "1", CoordinatePlane.XY, new(4000, 4000))];
        view.User.Settle();
        Assert.InRange(view.Path.View.ScaleX, 0.9 * scale, 1.2 * scale);
    });

    [Theory]
    [InlineData(1030, true)]
    [InlineData(800, false)]
    public Task The_box_of_values_hides_no_button_and_nothing_of_the_path_if_there_is_room(double width, bool isRoom) =>
        At(Sample(), view =>
    {
        view.Window.Width = width;
        view.Window.Height = 480;
        view.User.Settle();
        var buttons = view.Path.GetVisualDescendants().OfType<Button>().Min(b => b.TranslatePoint(default, view.Path)!.Value.X);
        foreach (var name in new[] { "N120", "N140", "N160", "N700", "N1190" })
        {
            view.User.Click(view.Path, view.MiddleOf(name));
            Assert.StartsWith(name + "\n", view.Path.Values, StringComparison.Ordinal);
            var room = view.Path.ValuesRoom;
            Assert.True(
                new Rect(view.Path.Bounds.Size).WithWidth(buttons).Contains(room), $"{name} leaves the plot or lies under a button.");
            Assert.False(isRoom && view.Ends().Any(room.Contains), $"{name} hides the path.");
        }
    });

    private static OpenedProgram Sample() => OpenedProgram.Read(
        File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc")),
        NcDialects.DeltaNc300,
        TestContext.Current.CancellationToken);

    private static OpenedProgram Million()
    {
        var text = new StringBuilder("%\nN10 G21 G17 G90\n");
        for (var i = 2; i < 1_000_000; i++)
        {
            text.Append(System.Globalization.CultureInfo.InvariantCulture, $"N{i * 10} G1 X{i % 1000} Y{i / 1000}\n");
        }

        return Read(text.ToString());
    }

    private static OpenedProgram Read(string text) =>
        OpenedProgram.Read(Encoding.UTF8.GetBytes(text), NcDialects.FanucMill, TestContext.Current.CancellationToken);

    private static Task At(OpenedProgram program, Action<Shown> test) => At(program, view =>
    {
        test(view);
        return Task.CompletedTask;
    });

    private static Task At(OpenedProgram program, Func<Shown, Task> test) => Drawing.Needed().RunAsync(async () =>
    {
        Texts.Current.Language = Language.English;
        var picture = new ProgramPicture(program);
        var window = new Window { Width = 1280, Height = 1000, Content = new ContentControl { Content = picture } };
        window.Show();
        try
        {
            await test(new(window, picture, new ScreenUser(window).Settle()));
        }
        finally
        {
            window.Close();
        }
    });

    private sealed record Shown(Window Window, ProgramPicture Picture, ScreenUser User)
    {
        public ProgramText Text => Window.GetVisualDescendants().OfType<ProgramText>().Single();

        public PathPlot Path => Window.GetVisualDescendants().OfType<PathPlot>().Single();

        public Control? Find(string id) => Window.GetVisualDescendants()
            .OfType<Control>()
            .FirstOrDefault(c => c.IsEffectivelyVisible && AutomationProperties.GetAutomationId(c) == id);

        public void Tap(Point at) => User.Click(Text, at);

        /// <summary>The middle of a block's row in the text.</summary>
        public Point RowOf(string name) => new(200, ((BlockOf(name) + 0.5) * Text.RowHeight) - Text.Offset.Y);

        /// <summary>The middle of a block's move in the path.</summary>
        public Point MiddleOf(string name)
        {
            var (program, motion) = (Picture.Program, Picture.Program.Path.MotionOf(BlockOf(name)));
            var (from, to) = program.Moves.EndsOf(motion)!.Value;
            return Path.View.At(program.Moves.NearestOn(motion, from.Lerp(to, 0.5)));
        }

        /// <summary>Where the cuts end in the path.</summary>
        public IEnumerable<Point> Ends() => Enumerable.Range(0, Picture.Program.Moves.Count)
            .Where(m => Picture.Program.Path.Motions[m].IsCut)
            .Select(m => Picture.Program.Moves.EndsOf(m))
            .OfType<(Point2 From, Point2 To)>()
            .Select(e => Path.View.At(e.To));

        /// <summary>True if there is something in the color of what is chosen within a few pixels.</summary>
        public bool IsLit(Point at)
        {
            var color = ((Avalonia.Media.ISolidColorBrush)Path.ChosenBrush!).Color;
            var place = InWindow(at);
            return Enumerable.Range(-4, 9).Any(
                x => Enumerable.Range(-4, 9).Any(
                    y => User.PixelAt(new(place.X + x, place.Y + y)) is var p
                        && Math.Abs(p.R - color.R) + Math.Abs(p.G - color.G) + Math.Abs(p.B - color.B) < 12));
        }

        public bool HasInk(Point at) => User.PixelAt(InWindow(at)) == ((Avalonia.Media.ISolidColorBrush)Path.Ink!).Color;

        /// <summary>True if a line number stands in a block's row.</summary>
        public bool HasNumber(string name)
        {
            var row = Text.TranslatePoint(RowOf(name), Window)!.Value;
            var (left, ground) = (Text.TranslatePoint(default, Window)!.Value.X, ((Avalonia.Media.ISolidColorBrush)Text.Ground!).Color);
            return Enumerable.Range((int)left, (int)Text.Gutter).Any(x => User.PixelAt(new(x, (int)row.Y)) != ground);
        }

        /// <summary>True if what a block's row ends with is low in it, as dots are and letters are not.</summary>
        public bool EndsInDots(string name)
        {
            var middle = Text.TranslatePoint(RowOf(name), Window)!.Value;
            var ground = ((Avalonia.Media.ISolidColorBrush)Text.Ground!).Color;
            var end = (int)Text.TranslatePoint(new(Text.Bounds.Width, 0), Window)!.Value.X - 1;
            while (!Rows(end).Any())
            {
                end--;
            }

            return Enumerable.Range(end - 4, 5).SelectMany(Rows).All(y => y > 0);

            IEnumerable<int> Rows(int x) => Enumerable.Range(-10, 20).Where(y => User.PixelAt(new(x, (int)middle.Y + y)) != ground);
        }

        private PixelPoint InWindow(Point at) =>
            Path.TranslatePoint(at, Window)!.Value is var place ? new((int)place.X, (int)place.Y) : default;

        private int BlockOf(string name) => Enumerable.Range(0, Picture.Program.Count).First(b => Picture.Program.NameOf(b) == name);
    }
}
