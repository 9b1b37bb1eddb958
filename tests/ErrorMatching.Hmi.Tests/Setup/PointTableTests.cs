using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A table of coordinates that does not fit the points is told so, puts none on a wrong point,
/// and is taken once what was advised is done.</summary>
public sealed class PointTableTests
{
    private static readonly string Drawing = Repository.PathTo("samples", "complex-mating", "theoretical.csv");

    [Theory]
    [InlineData(
        false,
        "Nothing imported: 17 rows for 16 points without coordinates. Only in the table: 2a, 3a, 3b. Only in the features: 15, 16. "
            + "Correct the number of points in Point set-up. For a row of no feature, such as a tip, tap Add point and type its "
            + "label. Then read the table again.")]
    [InlineData(true, "未讀入任何座標：表格有 17 行，而尚無座標的點有 16 個。僅表格有 2a、3a、3b。僅特徵有 15、16。請在點位設定更正點數；不屬於特徵的點（例如頂點），請在此點選「新增點」並輸入其標籤。然後再讀取一次表格。")]
    public Task A_drawing_with_a_tip_of_no_feature_is_taken_once_the_tip_is_named(bool isChinese, string refused) =>
        SetupSeat.AtAsync(ScreenKeys.Points, seat =>
    {
        if (isChinese)
        {
            seat.Seat.Tap("language");
        }

        Count(seat, 10);
        var before = seat.Draft;
        Read(seat, Drawing);
        Assert.Equal(refused, seat.TextOf("setup-message"));
        Assert.Equal(2, ((TextBlock)seat.Seat.See("setup-message")).TextLayout.TextLines.Count);
        Assert.Same(before, seat.Draft);

        // The new point is at the end of the list: it comes in sight, and its label is typed at once.
        var label = $"edit-{DraftPaths.OtherLabel(0)[2..]}";
        seat.Seat.Tap("points-add").WaitFor(() => seat.Seat.Find(label) is { IsFocused: true }, "The new point is not gone to.");
        seat.Seat.Type(label, "3").User.Press(Key.Tab);
        seat.Settle();
        before = seat.Draft;
        Read(seat, Drawing);
        Assert.Equal(
            isChinese ? "表中有 17 點。依其順序的標籤：L1 1..2、T1 2a..4、C1 5..14。"
                : "The table has 17 points. Labels in order: L1 1..2, T1 2a..4, C1 5..14.",
            seat.TextOf("setup-notice"));
        Assert.Equal(
            MatingDraftFiles.Open(seat.JobFile).Points.Select(p => (p.Label, p.X, p.Y)),
            seat.Draft.Points.Select(p => (p.Label, p.X, p.Y)));
        seat.Seat.Tap("setup-undo");
        Assert.True(seat.Draft.IsSame(before));
    });

    [Fact]
    public Task What_is_advised_where_a_table_has_other_points_leads_to_a_job_with_its_points() =>
        SetupSeat.AtAsync(ScreenKeys.Points, seat =>
    {
        Count(seat, 3);
        var drawing = DemoCell.Drawing(Drawing);
        string[] labels = [.. drawing.Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(l => l.Split(',')[0])];
        Paste(seat, drawing);
        Assert.StartsWith(
            "Nothing imported: 16 rows for 9 points without coordinates.", seat.TextOf("setup-message"), StringComparison.Ordinal);
        Assert.Contains("Correct the number of points in Point set-up.", seat.TextOf("setup-message"), StringComparison.Ordinal);
        seat.Seat.Tap("nav-points").Type("edit-features[2].points", "10").User.Press(Key.Enter);
        seat.Settle();
        Paste(seat, drawing);
        Assert.StartsWith("The table has 16 points. Labels in order:", seat.TextOf("setup-notice"), StringComparison.Ordinal);
        Assert.Equal(labels, seat.Draft.Features.SelectMany(f => f.Points).Select(p => p.Label));

        // Another table calls the first point otherwise: it is named so.
        var other = drawing.Replace("\n1,", "\nP1,", StringComparison.Ordinal);
        Paste(seat, other);
        Assert.Equal(
            "The table has 16 points. No point had the label P1: added at the end, in no feature, cutting nothing. If it belongs to a "
                + "feature, undo, give its point this label, and read the table again. Not in the table: 1.",
            seat.TextOf("setup-notice"));
        seat.Seat.Tap("setup-undo").Type("edit-features[0].points[0]", "P1").User.Press(Key.Tab);
        seat.Settle();
        Paste(seat, other);
        Assert.Equal("The table has 16 points.", seat.TextOf("setup-notice"));
        Assert.Equal(["P1", .. labels.Skip(1)], seat.Draft.Points.Select(p => p.Label));
    });

    [Theory]
    [InlineData(false, "No features yet: add them in Point set-up first. Coordinates belong to their points.", "Point set-up")]
    [InlineData(true, "尚無特徵：請先在點位設定新增特徵，座標屬於特徵的點。", "點位設定")]
    public Task Before_there_are_features_the_screen_says_where_to_add_them_and_takes_nothing(
        bool isChinese, string sentence, string button) =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        if (isChinese)
        {
            seat.Seat.Tap("language");
        }

        Assert.Null(seat.Seat.Find("points-no-features"));
        seat.Seat.Tap("setup-anew");
        seat.Settle();
        Assert.Equal(sentence, seat.TextOf("points-no-features"));
        Assert.Equal(button, Avalonia.Automation.AutomationProperties.GetName(seat.Seat.See("points-to-features")));
        seat.Seat.Tap("points-read");
        Assert.Null(seat.Shell.Choosing);
        Assert.Equal(sentence, seat.TextOf("setup-message"));
        Paste(seat, File.ReadAllText(Drawing));
        Assert.Equal(sentence, seat.TextOf("setup-message"));
        Assert.Empty(seat.Draft.Points);

        // What is counted there takes the drawing's labels, and nothing is to be said any more.
        seat.Seat.Tap("points-to-features").Tap("add-line");
        Assert.Equal(["1", "2"], seat.Draft.Points.Select(p => p.Label));
        seat.Seat.Tap("nav-system");
        Assert.Null(seat.Seat.Find("points-no-features"));
        Paste(seat, "A\t1\t2\nB\t3\t4");
        Assert.Equal([("A", "1"), ("B", "3")], seat.Draft.Points.Select(p => (p.Label, p.X)));
    });

    [Theory]
    [InlineData("1\t1\t1\n2\t1\t1\n2\t2\t2", "Nothing imported: the table has the label 2 more than once.")]
    [InlineData(
        "1\t1\n2\t2",
        "Nothing imported: 2 rows without labels for 17 points. Label each row with its point, or give every point a row, in the order "
            + "of the list.")]
    public Task A_table_that_is_no_list_of_the_points_changes_none(string table, string told) =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var before = seat.Draft;
        Paste(seat, table);
        Assert.Equal(told, seat.TextOf("setup-message"));
        Assert.Same(before, seat.Draft);
    });

    private static void Count(SetupSeat seat, int ofCurve)
    {
        seat.Seat.Tap("setup-anew")
            .Tap("add-line")
            .Tap("add-triangle")
            .Tap("add-curve")
            .Type("edit-features[2].points", Shown.Id(ofCurve)).User
            .Press(Key.Enter);
        seat.Settle();
    }

    private static void Read(SetupSeat seat, string file)
    {
        seat.Seat.Tap("nav-system").Tap("points-read").Type("chooser-path", file).Tap("chooser-confirm");
        seat.Seat.WaitFor(() => seat.Shell.Choosing is null && !seat.System.ReadPoints.IsRunning, "The file is not read.");
        seat.Settle();
    }

    private static void Paste(SetupSeat seat, string table)
    {
        seat.Seat.Tap("nav-system").See("points-paste");
        seat.System.Paste(table);
        seat.Settle();
    }
}
