using System.Text.Json.Nodes;
using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Platform;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>
/// The whole story at one seat, in each language: a setter signs in, sets up the complex mating from nothing, picks its blocks by tapping,
/// a part arrives, every value is what the console says of the sample's own files, it is approved and cut, verified by the second
/// measurement, found again, and the seat is left.
/// </summary>
[Trait("Length", "Long")]
public sealed class StoryTests
{
    private static readonly string[] Labels = ["1", "2", "2a", "3a", "3b", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14"];
    private static readonly string Sample = Repository.PathTo("samples", "complex-mating");

    [Theory]
    [InlineData(false, Explicit = true)]
    [InlineData(true)]
    public Task From_nothing_to_signing_out(bool isChinese) => Seat.AtAsync(seat =>
    {
        if (isChinese)
        {
            seat.Tap("language");
        }

        seat.SignIn(DemoCell.Setter);
        SetUp(seat, isChinese);

        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        var computed = seat.WaitFor(1, CorrectionState.Proposed);
        MustBeTheConsoles(JsonNode.Parse(seat.Station.Store.Content(computed.ReportSha256!))!);

        seat.Tap("nav-overview").See("waiting-1");
        seat.Tap("waiting-1").See("detail-title");
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
        seat.Tap("tab-decisions");
        Assert.StartsWith(isChinese ? "程式檢核通過" : "Proved", seat.TextOf("detail-proof"), StringComparison.Ordinal);
        seat.Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        var sent = seat.WaitFor(1, CorrectionState.Verified);
        Assert.Equal(
            seat.Station.Store.Content(sent.ProgramSha256!), File.ReadAllBytes(Path.Combine(seat.Cell.MachineFolder, "counterpart.nc")));
        seat.Cell.FinishPiece();
        seat.WaitFor(1, CorrectionState.Released);

        seat.Tap("nav-verification").WaitFor(
            () => seat.Find("piece-kind") is not null && seat.TextOf("piece-kind") == (isChinese ? "預測" : "Predicted"),
            "The piece is not shown.");
        seat.Cell.DeliverCounterpart(1, 0);
        seat.WaitFor(
            () => seat.TextOf("piece-kind") == (isChinese ? "實測" : "Measured"), "The second measurement does not verify the piece.");

        seat.Tap("nav-history").See("found-1");
        seat.Type("history-serial", "0001").Tap("history-search").See("found-1");
        seat.Tap("found-1").WaitFor(() => seat.Find("detail-state") is not null, "It is not opened.");
        Assert.Equal(isChinese ? "加工完成" : "Cut and released", seat.TextOf("detail-state"));
        seat.Tap("sign-out").WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
    });

    private static void SetUp(Seat seat, bool isChinese)
    {
        seat.Tap("nav-points");
        var here = new SetupSeat(seat).Settle();
        seat.Tap("setup-anew").Type("edit-workOrder", "WO-2021-02").Type("edit-name", "Complex mating");
        seat.Tap("add-line")
            .Tap("add-triangle")
            .Tap("add-curve")
            .Type("edit-features[1].name", "L2L3")
            .Type("edit-features[2].points", "10");
        seat.User.Press(Key.Enter);
        here.Settle();
        Assert.Equal(isChinese ? "示意圖：共 16 點，尚無座標。" : "Schematic: 16 points, none with coordinates yet.", seat.TextOf("points-caption"));

        seat.Tap("nav-system");
        var table = DemoCell.Drawing(Path.Combine(Sample, "theoretical.csv")).Replace(',', '\t');
        ClipboardExtensions.SetTextAsync(TopLevel.GetTopLevel(seat.Window)!.Clipboard!, table).GetAwaiter().GetResult();
        seat.Tap("points-paste").WaitFor(() => here.Draft.Points.All(p => p.X.Length > 0), "Nothing is pasted.");
        Assert.Equal(Labels, here.Draft.Points.Select(p => p.Label));
        seat.Tap("side-blocks").Tap("program-import").Type("chooser-path", Path.Combine(Sample, "counterpart.nc")).Tap("chooser-confirm");
        seat.WaitFor(() => here.System.Picture?.Program.Count > 0, "The program is not opened.");
        here.Settle();

        // Blocks of three features, two limits each, the tool and the gauge's uncertainty.
        Assert.Equal(isChinese ? "待填寫 11 項" : "To fill in: 11", AutomationProperties.GetName(seat.See("setup-problems")));
        Pick("N120", 0, "N120");
        Pick("N130", 3, "N130..N160");
        Pick("N170", 102, "N170..N1190");
        Assert.Equal(["N120", "N130..N160", "N170..N1190"], here.Draft.Features.Select(f => f.Blocks));
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

        // It is saved beside the job that runs, and takes its place once somebody signs that.
        var editing = here.Shell.Editing;
        seat.Tap("setup-save").WaitFor(() => editing.Notice is not null && editing.IsBeside, "It is not saved.");
        here.Settle();
        seat.User.Wait(TimeSpan.FromMilliseconds(600));
        seat.Tap("setup-put-in-use").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(() => editing.Notice is not null && !editing.IsBeside, "It is not put in use.");
        Assert.StartsWith(isChinese ? "已儲存" : "Saved", seat.TextOf("setup-notice"), StringComparison.Ordinal);

        void Fill(string id, string text)
        {
            seat.See(id).BringIntoView();
            seat.User.Settle();
            seat.Type(id, text);
        }

        // Taps a move, which lights its block and brings it into view; then the block, and from there to the last one.
        void Pick(string name, int more, string blocks)
        {
            var (picture, text, path) = (here.System.Picture!, (ProgramText)seat.See("program-text"), (PathPlot)seat.See("program-path"));
            var block = Enumerable.Range(0, picture.Program.Count).First(b => picture.Program.NameOf(b) == name);
            var (moves, motion) = (picture.Program.Moves, picture.Program.Path.MotionOf(block));
            var (from, to) = moves.EndsOf(motion)!.Value;
            seat.User.Click(path, path.View.At(moves.NearestOn(motion, from.Lerp(to, 0.5))));
            Assert.Equal(name, picture.Chosen);
            seat.User.Click(text, new Point(text.Bounds.Width / 2, ((block + 0.5) * text.RowHeight) - text.Offset.Y));
            Assert.Equal(name, picture.Chosen);
            while (picture.Selection!.Value.Count <= more || picture.Program.NameOf(picture.Cursor) != blocks.Split("..")[^1])
            {
                seat.User.Press(Key.Down, RawInputModifiers.Shift);
            }

            var feature = here.Draft.Features.ToList().FindIndex(f => f.Blocks.Length == 0);
            seat.Tap("program-take").WaitFor(() => here.Draft.Features[feature].Blocks == blocks, $"{blocks} are not taken.");
            here.Settle();
        }
    }

    private static void MustBeTheConsoles(JsonNode actual)
    {
        var console = MatingRun.Run(
            new(Path.Combine(Sample, "job.json")),
            new() { Program = new(Path.Combine(Sample, "counterpart.nc")) },
            TestContext.Current.CancellationToken).Result!;
        var expected = JsonNode.Parse(console.ReportJson())!;

        // The marker names the measurement's bytes, which are not those of the sample's file.
        Assert.StartsWith("(ERRORMATCH MEASUREMENT=", expected["proof"]!["marker"]!.GetValue<string>(), StringComparison.Ordinal);
        (expected["proof"]!["marker"], actual["proof"]!["marker"]) = (null, null);
        foreach (var part in new[] { "features", "keyPoints", "proof", "compensation", "alignment", "warnings" })
        {
            Assert.Equal(expected[part]?.ToJsonString(), actual[part]?.ToJsonString());
        }

        Assert.Equal(Blocks(expected), Blocks(actual));
        Assert.Equal(
            (expected["job"]!["name"]!.GetValue<string>(), "WO-2021-02"),
            (actual["job"]!["name"]!.GetValue<string>(), actual["job"]!["workOrder"]!.GetValue<string>()));

        static string[] Blocks(JsonNode report) => [
            .. report["program"]!["blocks"]!.AsArray()
                .Select(b => b!.ToJsonString())
                .Where(b => !b.Contains("ERRORMATCH MEASUREMENT=", StringComparison.Ordinal))];
    }
}
