using System.Globalization;
using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A new job from a drawing and a program: nobody types a coordinate or picks a block.</summary>
public sealed class DrawnJobTests
{
    // The blocks that the sample's own job names, with the two flanks of its triangle apart.
    private static readonly string[] Blocks =
        ["N100", "N120", "N140", "N160", "N180", "N200", "N210..N920", "N930", "N950", "N970"];

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_job_is_made_from_the_sample_s_drawing_with_at_most_twelve_taps(bool isChinese) => At(seat =>
    {
        if (isChinese)
        {
            seat.Seat.Tap("language");
        }

        var taps = 0;
        Tap("nav-points");
        seat.Settle();
        Tap("setup-anew");
        Tap("points-from-drawing");
        seat.Seat.See("entry-outline.dxf");
        Assert.Equal(Path.Combine(seat.Seat.Cell.SamplesFolder, "outline.dxf"), ((TextBox)seat.Seat.See("chooser-path")).Text);
        Tap("chooser-confirm");
        seat.Seat.See("entry-dovetail.nc");
        Assert.Equal(Path.Combine(seat.Seat.Cell.SamplesFolder, "dovetail.nc"), ((TextBox)seat.Seat.See("chooser-path")).Text);

        // The button is where that of the dialog before was: a tap at once is a habitual double tap, and opens nothing.
        seat.Seat.User.Wait(TimeSpan.FromMilliseconds(600));
        Tap("chooser-confirm");
        var choice = Choice(seat);

        // Which outline mates is asked, and nothing can be taken before somebody says so.
        Assert.Equal(["OUTLINE", "CENTER"], choice.Layers.Select(l => l.Name));
        Assert.False(seat.Seat.See("outline-take").IsEffectivelyEnabled);
        Assert.Empty(choice.Picture.Outline);
        Tap(choice.Layers.Single(l => l.Name == "OUTLINE").Id);
        seat.Seat.WaitFor(() => choice.Picture.Outline.Count > 0, "The outline is not shown.");
        Assert.StartsWith(isChinese ? "特徵：10 個" : "Features: 10.", seat.TextOf("outline-found"), StringComparison.Ordinal);

        // It lies where the program leaves it: the tool's radius below the path of the flat top.
        Assert.Contains(choice.Picture.Outline.SelectMany(l => l), p => Math.Abs(p.Y) < 1e-3 && Math.Abs(p.X) < 40);
        Assert.Empty(seat.Draft.Features);
        Type("outline-lower", "-0.02");
        Type("outline-upper", "+0.02");
        Type("outline-uncertainty", "0.002");
        Tap("outline-take");
        seat.Settle();
        Assert.Equal(Blocks, seat.Draft.Features.Select(f => f.Blocks));
        Assert.All(seat.Draft.Features, f => Assert.Equal(("-0.02", "+0.02"), (f.Lower, f.Upper)));
        Assert.Equal(("outline", "8", "dovetail.nc"), (
            seat.Draft.Name, seat.Draft["$.counterpart.toolDiameterMm"], seat.Draft["$.counterpart.program"]));
        Assert.Equal("", string.Join('\n', seat.Shell.Editing.Problems));
        Tap("setup-save");
        seat.Seat.WaitFor(() => seat.Shell.Editing.Notice is not null && seat.Shell.Editing.IsBeside, "It is not saved.");
        Assert.InRange(taps, 1, 12);

        void Tap(string id)
        {
            taps++;
            seat.Seat.Tap(id);
        }

        void Type(string id, string text)
        {
            taps++;
            seat.Seat.Type(id, text);
        }
    });

    [Fact]
    public Task An_outline_that_the_program_does_not_cut_is_refused_and_nothing_changes() => At(seat =>
    {
        seat.Seat.Tap("nav-points");
        seat.Settle();
        var before = seat.Draft;
        seat.Seat.Tap("points-from-drawing").See("entry-outline.dxf");
        seat.Seat.Tap("chooser-confirm").Tap("entry-counterpart.nc").Tap("chooser-confirm");
        var choice = Choice(seat);
        seat.Seat.Tap(choice.Layers.Single(l => l.Name == "OUTLINE").Id);
        seat.Seat.WaitFor(() => choice.Refused is not null, "Nothing is said.");
        Assert.StartsWith(
            "This outline cannot be laid on what the program cuts.", seat.TextOf("outline-refused"), StringComparison.Ordinal);
        Assert.False(seat.Seat.See("outline-take").IsEffectivelyEnabled);
        seat.Seat.Tap("outline-leave").See("setup-save");
        Assert.Same(before, seat.Draft);
    });

    [Fact]
    public Task A_file_that_is_no_drawing_is_told_and_undo_brings_back_what_was_there() => At(seat =>
    {
        seat.Seat.Tap("nav-points");
        seat.Settle();
        var (before, broken) = (seat.Draft, Path.Combine(Path.GetDirectoryName(seat.JobFile)!, "broken.dxf"));
        File.WriteAllText(broken, "0\nSECTION\n2\nENT");
        seat.Seat.Tap("points-from-drawing").Type("chooser-path", broken).Tap("chooser-confirm");
        seat.Seat.Tap("place-0").Tap("entry-counterpart.nc").Tap("chooser-confirm");
        seat.Seat.WaitFor(() => seat.Seat.Find("setup-message") is not null, "Nothing is said.");
        Assert.Contains("broken.dxf", seat.TextOf("setup-message"), StringComparison.Ordinal);
        Assert.True(seat.Setup.IsForm);

        // The tool of the job that is replaced, 6 mm, is not the one of this program.
        seat.Seat.Tap("points-from-drawing").Tap("entry-outline.dxf").Tap("entry-dovetail.nc");
        Assert.Equal("6", before["$.counterpart.toolDiameterMm"]);
        var choice = Choice(seat);
        seat.Seat.Tap(choice.Layers.Single(l => l.Name == "OUTLINE").Id);
        seat.Seat.WaitFor(() => choice.Picture.Outline.Count > 0, "The outline is not shown.");
        var pictures = new Pictures(seat.Seat);
        pictures.Take("outline");
        pictures.MustBeClean();
        Texts.Current.Language = Language.English;
        seat.Seat.Tap("outline-take");
        seat.Settle();
        Assert.Equal(Blocks, seat.Draft.Features.Select(f => f.Blocks));
        Assert.Equal("8", seat.Draft["$.counterpart.toolDiameterMm"]);
        seat.Seat.Tap("setup-undo");
        Assert.True(seat.Draft.IsSame(before));
    });

    [Fact]
    public Task A_drawing_in_inches_is_asked_about_and_read_so_and_a_job_changed_meanwhile_is_not_written_into() => At(seat =>
    {
        seat.Seat.Tap("nav-points");
        seat.Settle();
        var inches = Path.Combine(Path.GetDirectoryName(seat.JobFile)!, "inches.dxf");
        Point2[] corners = [new(0, 0), new(40, 0), new(40, 10), new(26, 10), new(26, 30), new(0, 30)];
        var lines = corners.Select((p, i) =>
        {
            var q = corners[(i + 1) % corners.Length];
            return string.Create(
                CultureInfo.InvariantCulture,
                $"0\nLINE\n8\nA\n10\n{p.X / 25.4}\n20\n{p.Y / 25.4}\n11\n{q.X / 25.4}\n21\n{q.Y / 25.4}\n");
        });
        File.WriteAllText(inches, "0\nSECTION\n2\nENTITIES\n" + string.Concat(lines) + "0\nENDSEC\n0\nEOF\n");
        var program = Path.ChangeExtension(inches, "nc");
        File.WriteAllText(
            program,
            "%\nO1\nN10 G21 G17 G40 G90 G54\nN20 G0 X-20. Y-4.\nN30 G1 Z-5. F200.\nN40 X44. F500.\nN50 Y14.\nN60 X30.\nN70 Y34.\n"
                + "N80 X-4.\nN90 Y-20.\nN100 G0 Z50.\nN110 M30\n%\n");
        seat.Seat.Tap("points-from-drawing").Type("chooser-path", inches).Tap("chooser-confirm");
        seat.Seat.WaitFor(
            () => seat.Shell.Choosing is { } second && second.Title.Contains("program", StringComparison.Ordinal), "No program is asked.");
        seat.Seat.User.Wait(TimeSpan.FromMilliseconds(600));
        seat.Seat.Type("chooser-path", program).Tap("chooser-confirm");

        // One layer alone is laid at once.
        var choice = Choice(seat);
        seat.Seat.WaitFor(() => choice.OtherUnit is not null, "The unit is not asked about.");
        Assert.Equal("Read the drawing in inches", choice.OtherUnit);
        Assert.False(seat.Seat.See("outline-take").IsEffectivelyEnabled);
        seat.Seat.Tap("outline-unit").WaitFor(() => choice.Picture.Outline.Count > 0, "The outline is not shown.");
        Assert.Null(choice.OtherUnit);

        // What the list said of the layer in millimeters is not true of it in inches.
        Assert.StartsWith("Curves: 6. The program cuts 9", choice.Layers[0].Text, StringComparison.Ordinal);

        // Undo does not reach the form behind it, but somebody else's change is seen.
        var before = seat.Draft;
        seat.Seat.User.Press(Key.Z, RawInputModifiers.Control);
        Assert.Same(before, seat.Draft);
        seat.Shell.Editing.Change("", d => d.With("$.workOrder", "other"));
        seat.Seat.Tap("outline-take");
        Assert.Equal("The job was changed in the meantime. Choose the drawing again.", seat.TextOf("outline-refused"));
        Assert.Equal(before.Features, seat.Draft.Features);
        seat.Seat.Tap("outline-leave").See("setup-save");
    });

    private static OutlineChoice Choice(SetupSeat seat)
    {
        seat.Seat.WaitFor(() => seat.Setup.Outline is not null, "No outline is shown.");
        seat.Seat.User.Settle();
        return seat.Setup.Outline!;
    }

    private static Task At(Action<SetupSeat> test) => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            test(new(seat));
        },
        hasSamples: true);
}
