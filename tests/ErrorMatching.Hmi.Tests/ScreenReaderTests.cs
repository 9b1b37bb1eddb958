using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Automation.Provider;
using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What a screen reader says of controls that draw themselves. That everything on each screen has a name and a role is measured
/// with the pictures (<see cref="Layout"/>).</summary>
public sealed class ScreenReaderTests
{
    [Fact]
    public Task A_plot_is_a_picture_that_says_the_values_that_were_asked_for() => Drawing.Needed().RunAsync(() =>
    {
        var plot = new GapPlot
        {
            Drawing = new(
                [[new(0, 0), new(100, 1)]],
                [[new(0, 1), new(100, 0)]],
                [("A", new(0, 0), new(0, 1), 0.0005, 0.01, false), ("B", new(100, 1), new(100, 0), -0.0125, 0.02, false)],
                new(0, 0, 100, 1),
                1,
                0.0125,
                IsLong: true,
                IsTurned: false)
        };
        Show(plot, user =>
        {
            var (peer, heard) = (PeerOf(plot, AutomationControlType.Image), new List<object?>());
            peer.PropertyChanged += (_, e) => heard.AddRange(e.Property == ValuePatternIdentifiers.ValueProperty ? [e.NewValue] : []);
            Assert.Null(peer.GetProvider<IValueProvider>()!.Value);
            plot.Focus();
            user.Press(Key.PageDown).Press(Key.PageDown);
            Assert.Equal(
                "B: error +0.0125\u00a0mm\npart +0.0200\u00a0mm",
                peer.GetProvider<IValueProvider>()!.Value);
            Assert.Equal(2, heard.Count);
            Assert.Equal(plot.Values, heard[^1]);
        });
    });

    [Fact]
    public Task A_program_is_a_document_that_says_the_line_that_the_keys_went_to() => Drawing.Needed().RunAsync(() =>
    {
        var text = new ProgramText
        {
            Picture = new(OpenedProgram.Read(
                File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc")),
                NcDialects.DeltaNc300,
                TestContext.Current.CancellationToken))
        };
        Show(text, user =>
        {
            var peer = PeerOf(text, AutomationControlType.Document);
            text.Focus();
            user.Press(Key.Home).Press(Key.Down);
            Assert.Equal(
                File.ReadLines(Repository.PathTo("samples", "complex-mating", "counterpart.nc")).ElementAt(1),
                peer.GetProvider<IValueProvider>()!.Value);
            Assert.True(peer.GetProvider<IValueProvider>()!.IsReadOnly);
        });
    });

    [Fact]
    public Task A_changed_line_is_said_whole_and_its_changed_words_beside_it() => Drawing.Needed().RunAsync(() =>
    {
        var line = new MarkedText { Line = "N130 G1 X1.5 Y2", Spans = [new(8, 4), new(13, 2)] };
        Show(line, _ =>
        {
            var peer = PeerOf(line, AutomationControlType.Text);
            Assert.Equal(("N130 G1 X1.5 Y2", "Changed: X1.5, Y2"), (peer.GetName(), peer.GetHelpText()));
            line.Spans = [];
            Assert.Equal(("N130 G1 X1.5 Y2", ""), (peer.GetName(), peer.GetHelpText() ?? ""));
        });
    });

    [Fact]
    public Task The_colors_of_a_map_say_how_far_they_go() => Drawing.Needed().RunAsync(() =>
    {
        var legend = new ColorLegend { LimitMm = 0.025 };
        Show(legend, _ => Assert.Equal("−25 µm, +25 µm", PeerOf(legend, AutomationControlType.Image).GetProvider<IValueProvider>()!.Value));
    });

    private static AutomationPeer PeerOf(Control control, AutomationControlType type)
    {
        var peer = ControlAutomationPeer.CreatePeerForElement(control);
        Assert.Equal(type, peer.GetAutomationControlType());
        Assert.True(peer.IsContentElement() && peer.IsControlElement());
        return peer;
    }

    private static void Show(Control control, Action<ScreenUser> test)
    {
        Texts.Current.Language = Language.English;
        var window = new Window { Width = 600, Height = 400, Content = control };
        window.Show();
        try
        {
            test(new ScreenUser(window).Settle());
        }
        finally
        {
            window.Close();
        }
    }
}
