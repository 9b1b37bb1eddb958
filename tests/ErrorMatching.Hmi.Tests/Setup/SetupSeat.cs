using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A person in front of a set-up screen.</summary>
internal sealed class SetupSeat(Seat seat)
{
    public Seat Seat => seat;

    public ShellViewModel Shell => seat.Shell;

    public MatingDraft Draft => seat.Shell.Editing.Draft;

    public PointsViewModel Setup => (PointsViewModel)seat.Shell.Current!;

    public SystemViewModel System => (SystemViewModel)seat.Shell.Current!;

    public string JobFile => seat.Station.Settings.Jobs[0].File;

    /// <summary>Does a test at a set-up screen whose job is opened.</summary>
    public static Task AtAsync(string screen, Action<SetupSeat> test, string user = DemoCell.Setter) => Seat.AtAsync(seat =>
    {
        seat.SignIn(user);
        seat.Tap("nav-" + screen);
        var here = new SetupSeat(seat);
        here.Settle();
        test(here);
    });

    public string? TextOf(string id) => seat.TextOf(id);

    /// <summary>Waits until the job is opened, looked through and kept.</summary>
    public SetupSeat Settle()
    {
        var editing = seat.Shell.Editing;
        seat.WaitFor(
            () => editing.Loading.IsCompleted
                && editing.Behind.IsCompleted
                && (editing.IsChecked || editing.Job is null || editing.Message is not null),
            "The job is not looked through.");
        seat.User.Settle();
        return this;
    }
}
