using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A surface is approved or rejected where it is looked at, as in the on-line compensation.</summary>
public sealed class FreeformDecidingTests
{
    [Theory]
    [InlineData(Language.English)]
    [InlineData(Language.TraditionalChinese)]
    public Task The_same_is_signed_for_as_in_the_on_line_compensation(Language language) => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Setter);
        Texts.Current.Language = language;
        seat.User.Settle();
        foreach (var act in new[] { "approve", "reject" })
        {
            seat.Tap("nav-freeform").Tap("freeform-" + act).See("signing-confirm");
            var here = What();
            seat.Tap("signing-leave").Tap("nav-compensation").Tap(act).See("signing-confirm");
            Assert.Equal(What(), here);
            seat.Tap("signing-leave");
        }

        string What()
        {
            var signing = seat.Shell.Signing!;
            return string.Join(
                '\n',
                [
                    signing.Title, signing.Subject, signing.Consequence, signing.Target, $"{signing.NeedsReason} {signing.NeedsPassword}",
                    $"{signing.Correction!.Id} {signing.Correction.Version}", .. signing.Facts.Select(f => $"{f.Severity} {f.Text}")]);
        }
    });

    [Fact]
    public Task What_is_approved_is_what_is_shown_and_it_stays_to_be_seen() => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Setter);
        seat.Tap("freeform-approve").See("signing-password");

        // Another one comes while the dialog is open: the signature is for the one behind it.
        seat.Cell.DeliverSurface(2, 0.01);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(() => seat.Station.Store.Find(1)!.State != CorrectionState.Proposed, "It is not approved.");
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(2)!.State);
        seat.WaitFor(() => seat.TextOf("surface-title") == "#1 · 0001", "What was approved is not shown.");
        seat.WaitFor(() => seat.Find("freeform-approve") is null, "What is approved can be approved again.");
    });

    [Fact]
    public Task An_operator_rejects_and_does_not_approve() => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Operator);
        Assert.False(seat.See("freeform-approve").IsEffectivelyEnabled);
        Assert.Equal("A setter must approve this. You can reject it.", seat.TextOf("freeform-forbidden"));
        seat.Tap("freeform-reject").Type("signing-reason", "chip under the probe").Tap("signing-confirm");
        seat.WaitFor(() => seat.Station.Store.Find(1)!.State == CorrectionState.Rejected, "It is not rejected.");
        seat.WaitFor(() => seat.Find("freeform-reject") is null, "What is rejected can be rejected again.");
    });

    [Fact]
    public Task What_changes_by_itself_is_not_decided_about_for_a_second() => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Setter);
        seat.WaitFor(() => seat.See("freeform-approve").IsEffectivelyEnabled, "Who comes to the screen has to wait.");
        seat.Clock.Stand();
        seat.Cell.DeliverSurface(2, 0.01);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.WaitFor(() => seat.TextOf("surface-title") == "#2 · 0002", "The next one is not shown.");
        Assert.False(seat.See("freeform-approve").IsEffectivelyEnabled);
        Assert.False(seat.See("freeform-reject").IsEffectivelyEnabled);
        Assert.Equal("This has just changed. You can decide in a moment.", seat.TextOf("freeform-forbidden"));
        seat.Clock.Advance(Pause.Length);
        seat.WaitFor(() => seat.See("freeform-approve").IsEffectivelyEnabled, "The pause does not end.");

        // What the person chooses changes nothing under the finger.
        seat.Tap("surface-1").WaitFor(() => seat.TextOf("surface-title") == "#1 · 0001", "It is not shown.");
        Assert.True(seat.See("freeform-approve").IsEffectivelyEnabled);
    });

    private static void Arrive(Seat seat, string user)
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(user).Tap("nav-freeform").See("map");
        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to propose.");
    }
}
