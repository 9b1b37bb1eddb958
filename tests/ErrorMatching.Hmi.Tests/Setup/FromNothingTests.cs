using System.Text.Json.Nodes;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Platform;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The complex mating is set up from nothing on the screens, and what the cell computes by it is what the console says to the sample's own files.</summary>
public sealed class FromNothingTests
{
    private static readonly string[] Labels = ["1", "2", "2a", "3a", "3b", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14"];

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_job_from_nothing_gives_the_sample_s_result(bool isChinese) => Seat.AtAsync(seat =>
    {
        var sample = Repository.PathTo("samples", "complex-mating");
        if (isChinese)
        {
            seat.Tap("language");
        }

        seat.SignIn(DemoCell.Setter).Tap("nav-points");
        var here = new SetupSeat(seat).Settle();
        seat.Tap("setup-anew").Type("edit-workOrder", "WO-2021-02").Type("edit-name", "Complex mating");
        seat.Tap("add-line").Tap("add-triangle").Tap("add-curve").Type("edit-features[1].name", "L2L3").Type("edit-features[2].points", "10");
        seat.User.Press(Key.Enter);
        here.Settle();
        Assert.Equal(isChinese ? "示意圖：共 16 點，尚無座標。" : "Schematic: 16 points, none with coordinates yet.", seat.TextOf("points-caption"));

        seat.Tap("nav-system");
        foreach (var (row, label) in here.System.Coordinates.Zip(Labels).Reverse())
        {
            row.Label.Text = label;
        }

        var table = File.ReadAllText(Path.Combine(sample, "theoretical.csv")).Replace(',', '\t');
        ClipboardExtensions.SetTextAsync(TopLevel.GetTopLevel(seat.Window)!.Clipboard!, table).GetAwaiter().GetResult();
        seat.Tap("points-paste");
        seat.WaitFor(() => here.Draft.Points.All(p => p.X.Length > 0), "Nothing is pasted.");
        seat.Tap("side-blocks").Tap("program-import").Type("chooser-path", Path.Combine(sample, "counterpart.nc")).Tap("chooser-confirm");
        seat.WaitFor(() => here.Draft.Program is not null, "No program is imported.");
        here.Settle();

        // Blocks of three features, two limits each, the tool and the gauge's uncertainty.
        Assert.Equal(isChinese ? "待修正 11 項" : "11 to mend", ((TextBlock)((Button)seat.See("setup-problems")).Content!).Text);
        Fill("edit-features[0].blocks", "N120");
        Fill("edit-features[1].blocks", "N130..N160");
        Fill("edit-features[2].blocks", "N170..N1190");
        seat.Tap("side-tolerances");
        for (var f = 0; f < 3; f++)
        {
            Fill($"edit-features[{Shown.Id(f)}].toleranceMm[0]", "-0.05");
            Fill($"edit-features[{Shown.Id(f)}].toleranceMm[1]", "+0.05");
        }

        seat.Tap("side-machine").Type("edit-counterpart.toolDiameterMm", "6");
        seat.Tap("side-gauge").Type("edit-gauge.uncertaintyMm", "0.0054").Type("edit-gauge.measuring.touches", "14");
        here.Settle();
        Assert.Equal("", string.Join('\n', here.Shell.Editing.Problems));
        seat.Tap("setup-save");
        seat.WaitFor(() => here.Shell.Editing.Notice is not null, "It is not saved.");
        Assert.StartsWith(isChinese ? "已儲存" : "Saved", seat.TextOf("setup-notice"), StringComparison.Ordinal);

        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        var computed = seat.WaitFor(1, CorrectionState.Proposed);
        var console = MatingRun.Of(new(Path.Combine(sample, "job.json")), new() { Program = new(Path.Combine(sample, "counterpart.nc")) }, TestContext.Current.CancellationToken).Result!;
        var (expected, actual) = (JsonNode.Parse(console.ReportJson())!, JsonNode.Parse(seat.Station.Store.Content(computed.ReportSha256!))!);
        foreach (var part in new[] { "features", "keyPoints", "proof", "compensation", "alignment", "warnings" })
        {
            Assert.Equal(expected[part]?.ToJsonString(), actual[part]?.ToJsonString());
        }

        Assert.Equal(expected["program"]!["blocks"]!.ToJsonString(), actual["program"]!["blocks"]!.ToJsonString());
        Assert.Equal((expected["job"]!["name"]!.GetValue<string>(), "WO-2021-02"), (actual["job"]!["name"]!.GetValue<string>(), actual["job"]!["workOrder"]!.GetValue<string>()));

        void Fill(string id, string text)
        {
            seat.See(id).BringIntoView();
            seat.User.Settle();
            seat.Type(id, text);
        }
    });
}
