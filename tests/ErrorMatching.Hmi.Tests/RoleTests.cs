using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Who may do what, at the buttons that do it and behind them.</summary>
[Trait("Length", "Long")]
public sealed class RoleTests
{
    // By whom each button can be pressed: everybody, a setter and higher, an administrator alone.
    private static readonly (string Screen, string? Side, string Button, string[] By)[] Proposed =
    [
        (ScreenKeys.Compensation, null, "reject", [DemoCell.Operator, DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.Compensation, null, "approve", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.Points, null, "setup-anew", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.Points, null, "add-line", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.Points, null, "feature-0-remove", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.System, "side-coordinates", "points-paste", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.System, "side-coordinates", "points-read", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.System, "side-blocks", "program-import", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.System, "side-tolerances", "chain-add", [DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.Settings, "user-row-otto", "users-new", [DemoCell.Administrator]),
        (ScreenKeys.Settings, "user-row-otto", "users-disable", [DemoCell.Administrator]),
        (ScreenKeys.Settings, "user-row-otto", "users-role", [DemoCell.Administrator]),
    ];

    private static readonly (string Screen, string? Side, string Button, string[] By)[] Sent =
    [
        (ScreenKeys.Compensation, null, "release", [DemoCell.Operator, DemoCell.Setter, DemoCell.Administrator]),
        (ScreenKeys.Compensation, null, "revert", [DemoCell.Setter, DemoCell.Administrator]),
    ];

    [Fact]
    public Task Each_role_has_its_buttons_and_no_other() => Seat.AtAsync(seat =>
    {
        File.Copy(
            Path.Combine(AppContext.BaseDirectory, "samples", "complex-mating", "counterpart.nc"),
            Path.Combine(seat.Cell.MachineFolder, "counterpart.nc"));
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        foreach (var (state, buttons) in new[] { (CorrectionState.Proposed, Proposed), (CorrectionState.Verified, Sent) })
        {
            if (state == CorrectionState.Verified)
            {
                new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
                seat.WaitFor(1, state);
            }

            foreach (var user in new[] { DemoCell.Operator, DemoCell.Setter, DemoCell.Administrator })
            {
                seat.SignIn(user);
                foreach (var (screen, side, button, by) in buttons)
                {
                    seat.Shell.Go(screen);
                    _ = side is null ? seat : seat.Tap(side);
                    seat.WaitFor(
                        () => Settled(seat) && IsOffered(seat, button) == by.Contains(user),
                        $"{button} is {(by.Contains(user) ? "not " : "")}offered to {user}.");
                }

                seat.Tap("sign-out").WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
            }
        }
    });

    [Fact]
    public Task What_a_role_must_not_is_refused_behind_the_button_as_well() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-compensation").See("approve");
        var isDone = false;
        foreach (var act in new[] { Act.Approve, Act.Revert, Act.ManageUsers, Act.ManageMachines })
        {
            // A button that was offered by mistake.
            seat.Shell.Sign(
                new(seat.Station, seat.Shell.Who!, act, "#1", needsReason: false, (_, _, _) => Task.FromResult(isDone = true))
                {
                    TitleKey = "Act.Approve"
                });
            seat.Type("signing-password", DemoCell.Password).User.Press(Key.Enter);
            Assert.Equal("Your role does not allow this.", seat.TextOf("signing-message"));
            seat.User.Press(Key.Escape);
        }

        Assert.False(isDone);
    });

    [Fact]
    public Task A_right_that_was_taken_away_meanwhile_is_gone_for_who_sits_there() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").Tap("approve").Type("signing-password", DemoCell.Password);
        seat.Station.Users.SetRole(seat.Station.Users.SignIn(DemoCell.Administrator, DemoCell.Password), DemoCell.Setter, Role.Operator);
        seat.User.Press(Key.Enter);
        Assert.Equal("Your role does not allow this.", seat.TextOf("signing-message"));
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
    });

    private static bool Settled(Seat seat) =>
        seat.Shell.Current is not CompensationViewModel { Detail: null } && seat.Shell.Editing.Loading.IsCompleted;

    private static bool IsOffered(Seat seat, string button) => seat.Find(button) is { IsEffectivelyEnabled: true };
}
