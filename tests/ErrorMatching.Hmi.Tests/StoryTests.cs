using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The whole story at one seat, in each language: somebody signs in, a part arrives, it is looked at, approved and cut, found again, and the seat is left.</summary>
public sealed class StoryTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task From_signing_in_to_signing_out(bool isChinese) => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        if (isChinese)
        {
            seat.Tap("language");
        }

        seat.SignIn(DemoCell.Setter);
        seat.WaitFor(() => seat.TextOf("overview-summary") == (isChinese ? "一切正常" : "All is well"), "All is not well.");
        seat.Cell.Deliver(7, 0);
        seat.See("waiting-1");
        seat.Tap("waiting-1");
        seat.WaitFor(() => seat.Find("detail-title") is not null, "The part is not shown.");
        Assert.Equal("#1 · 0007", seat.TextOf("detail-title"));
        Assert.StartsWith(isChinese ? "已證明" : "Proved", seat.TextOf("detail-proof"), StringComparison.Ordinal);
        seat.Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        var sent = seat.WaitFor(1, CorrectionState.Verified);
        Assert.Equal(seat.Station.Store.Content(sent.ProgramSha256!), File.ReadAllBytes(Path.Combine(seat.Cell.MachineFolder, "counterpart.nc")));

        seat.Cell.FinishPiece();
        seat.WaitFor(1, CorrectionState.Released);
        seat.Tap("nav-history").See("found-1");
        seat.Type("history-serial", "0007").Tap("history-search").See("found-1");
        seat.Tap("found-1");
        seat.WaitFor(() => seat.Find("detail-state") is not null, "It is not opened.");
        Assert.Equal(isChinese ? "已加工並釋放" : "Cut and released", seat.TextOf("detail-state"));
        seat.Tap("sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
    });
}
