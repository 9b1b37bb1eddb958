using Avalonia;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every screen in both themes, both languages and two sizes: looked at by measure here, and by people in artifacts/screenshots.</summary>
public sealed class ScreenshotTests
{
    private static readonly string[] Sides = ["features", "program", "gap", "decisions", "course"];

    [Fact]
    public Task No_text_is_cut_off_and_nothing_lies_over_anything_else() => Seat.AtAsync(seat =>
    {
        var problems = new List<string>();
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Shell.Banner is null && seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to run.");
        Everywhere("login", isPictured: true);
        seat.SignIn(DemoCell.Setter);
        Everywhere("overview", isPictured: true);

        seat.Shell.Go(Screens.Compensation);
        seat.See("points");
        Everywhere("compensation", isPictured: true);
        foreach (var side in Sides)
        {
            seat.Tap("tab-" + side);
            Everywhere("compensation-" + side, isPictured: false);
        }

        seat.Tap("approve");
        Everywhere("signing", isPictured: true);
        seat.Tap("signing-leave");

        seat.Shell.Go(Screens.History);
        seat.See("found-1");
        Everywhere("history", isPictured: true);
        seat.Shell.Go(Screens.Messages);
        seat.WaitFor(() => ((MessagesViewModel)seat.Shell.Current!).Entries.Count > 0, "The trail stays empty.");
        Everywhere("messages", isPictured: true);
        Assert.True(problems.Count == 0, string.Join('\n', problems.Distinct()));

        void Everywhere(string name, bool isPictured)
        {
            foreach (var size in new Size[] { new(1280, 800), new(1920, 1080) })
            {
                (seat.Window.Width, seat.Window.Height) = (size.Width, size.Height);
                foreach (var (language, code) in new[] { (Language.English, "en"), (Language.TraditionalChinese, "zh") })
                {
                    Texts.Current.Language = language;
                    seat.User.Settle();
                    problems.AddRange(Layout.Problems(seat.Window).Select(p => $"{name} {size.Width}x{size.Height} {code}: {p}"));
                    foreach (var isDark in new[] { false, true })
                    {
                        // The sides of the detail differ in content only: once in each language and theme is enough to look at.
                        if (isPictured || (size.Width < 1500 && isDark == (language == Language.TraditionalChinese)))
                        {
                            seat.Shell.IsDark = isDark;
                            seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", $"{name}-{(isDark ? "dark" : "light")}-{code}-{size.Width}x{size.Height}.png"));
                        }
                    }
                }
            }

            seat.Shell.IsDark = false;
            Texts.Current.Language = Language.English;
            (seat.Window.Width, seat.Window.Height) = (1280, 800);
            seat.User.Settle();
        }
    });
}
