using System.Text;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Layout;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What the tests of layouts see: layouts that are wrong on purpose.</summary>
public sealed class LayoutTests
{
    [Fact]
    public Task A_character_that_no_font_has_is_noticed() => Within(
        () => [
            new TextBlock { Text = "1 µm → 誤" },
            new TextBlock { Text = "lost: \u0378" },
            new TextBox { Text = "typed: \u0378", MinWidth = 300 }],
        "\"lost: \u0378\" has a character without a glyph",
        "TextPresenter  has a character without a glyph");

    [Fact]
    public async Task A_character_that_no_font_has_is_noticed_in_what_draws_its_words_itself()
    {
        var marked = Lines();
        await marked.MarkAsync([new("\u0378", ["N10"])]);
        await Within(
            () =>
            [
                Drawn("whole", new SeriesPlot { Drawing = new(["1 µm → 誤"], ["1"], [new(SeriesKind.Before, "誤差", [1])], [], []) }),
                Drawn("place", new SeriesPlot { Drawing = new(["\u0378"], ["1"], [new(SeriesKind.Before, "name", [1])], [], []) }),
                Drawn("name", new SeriesPlot { Drawing = new(["1"], ["1"], [new(SeriesKind.Before, "\u0378", [1])], [], []) }),
                Drawn("values", new SeriesPlot { Drawing = new(["1"], ["1\n\u0378"], [new(SeriesKind.Before, "name", [1])], [], []) }),
                Drawn(
                    "number",
                    new SurfacePlot
                    {
                        Drawing = new(
                            new(2, 2, [new(0, 0, 0), new(0, 1, 0), new(1, 0, 0), new(1, 1, 0)], []),
                            null,
                            1,
                            [("\u0378", new(0, 0), "1")],
                            ShowsWay: false)
                    }),
                Drawn(
                    "feature",
                    new PartPlot
                    {
                        Drawing = new(
                            [new("\u0378", [("1", new(0, 0)), ("2", new(1, 1))], [new(0, 0), new(1, 1)])], IsSchematic: false, 2, 2)
                    }),
                Drawn("limit", new ColorLegend { LimitMm = 1 }),
                new MarkedText { Line = "N10 \u0378", Spans = [new(4, 1)] },
                Drawn("marked", new ProgramText { Picture = marked }),
            ],
            "SeriesPlot place has a character without a glyph",
            "SeriesPlot name has a character without a glyph",
            "SeriesPlot values has a character without a glyph",
            "SurfacePlot number has a character without a glyph",
            "PartPlot feature has a character without a glyph",
            "\"N10 \u0378\" has a character without a glyph",
            "ProgramText marked has a character without a glyph");
    }

    [Fact]
    public Task What_is_touched_and_clipped_is_noticed_unless_it_is_scrolled_to() => Within(
        () =>
        [
            new Border { ClipToBounds = true, Width = 100, HorizontalAlignment = HorizontalAlignment.Left, Child = Wide("whole", 100) },
            new Border { ClipToBounds = true, Width = 60, HorizontalAlignment = HorizontalAlignment.Left, Child = Wide("clipped", 100) },
            new ScrollViewer
            {
                Height = 100,
                Content = new StackPanel { Children = { Wide("scrolled to", 100), Wide("scrolled to", 100) } }
            },
            new ScrollViewer
            {
                Width = 60,
                HorizontalAlignment = HorizontalAlignment.Left,
                HorizontalScrollBarVisibility = ScrollBarVisibility.Disabled,
                Content = Wide("aside", 100)
            },
            new Border { ClipToBounds = true, Height = 50, Child = new ScrollViewer { Height = 80, Content = Wide("below", 100) } },
            new ScrollViewer { Height = 40, Content = Wide("slit", 100) },
        ],
        "Button clipped is clipped by Border",
        "Button aside is clipped at the side",
        "ScrollContentPresenter  is clipped by Border",
        "Button slit is scrolled to, 57 high, through 40");

    [Fact]
    public Task A_field_that_is_lower_than_its_line_is_noticed() => Within(
        () => [Field("", "asked for", 57), Field("typed", null, 57), Field("", "asked for", 16), Field("typed", null, 16)],
        "TextBox low shows",
        "TextBox low shows");

    [Fact]
    public Task A_line_of_a_program_that_ends_where_nobody_sees_it_is_noticed() => Within(
        () =>
        [
            new Border
            {
                ClipToBounds = true,
                Width = 300,
                Height = 80,
                HorizontalAlignment = HorizontalAlignment.Left,
                Child = new ProgramText { Picture = Lines(), Width = 300 }
            },
            new Border
            {
                ClipToBounds = true,
                Width = 150,
                Height = 80,
                HorizontalAlignment = HorizontalAlignment.Left,
                Child = new ProgramText { Picture = Lines(), Width = 300, HorizontalAlignment = HorizontalAlignment.Left }
            },
        ],
        "line 2 of ProgramText  ends at");

    private static Button Wide(string name, double width)
    {
        var button = new Button { Width = width, Content = new TextBlock { Text = "a" } };
        AutomationProperties.SetAutomationId(button, name);
        AutomationProperties.SetName(button, name);
        return button;
    }

    private static TextBox Field(string text, string? placeholder, double height)
    {
        var field = new TextBox { Text = text, PlaceholderText = placeholder, MinHeight = 0, Height = height, Width = 200 };
        AutomationProperties.SetAutomationId(field, height < 57 ? "low" : "high");
        AutomationProperties.SetName(field, "field");
        return field;
    }

    private static Control Drawn(string name, Control control)
    {
        (control.MinHeight, control.Width) = (control is PlotArea ? 200 : 70, 300);
        AutomationProperties.SetAutomationId(control, name);
        AutomationProperties.SetName(control, name);
        return control;
    }

    private static ProgramPicture Lines() => new(OpenedProgram.Read(
        Encoding.ASCII.GetBytes("N10 G1\nN20 G1 X11.111 Y11\n"), NcDialects.FanucMill, TestContext.Current.CancellationToken));

    // Each complaint is found, and nothing else.
    private static Task Within(Func<Control[]> content, params string[] complaints) => Drawing.Needed().RunAsync(() =>
    {
        var stack = new StackPanel();
        stack.Children.AddRange(content());
        var window = new Window { Width = 800, Height = 2000, Content = stack };
        window.Show();
        try
        {
            _ = new ScreenUser(window).Settle();
            var found = Hidden.Problems(window).ToList();
            Assert.Equal(complaints.Length, found.Count);
            Assert.All(complaints.Zip(found), c => Assert.StartsWith(c.First, c.Second, StringComparison.Ordinal));
        }
        finally
        {
            window.Close();
        }
    });
}
