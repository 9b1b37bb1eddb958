using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What a seat shows at a moment, in both languages and themes:
/// measured, and two pictures for people in artifacts/screenshots.</summary>
internal static class BothLanguages
{
    /// <summary>Looks at what is shown now.</summary>
    /// <param name="seat">The seat.</param>
    /// <param name="name">With which the pictures begin.</param>
    public static void Take(Seat seat, string name)
    {
        foreach (var (language, isDark) in new[] { (Language.English, false), (Language.TraditionalChinese, true) })
        {
            Texts.Current.Language = language;
            seat.Shell.IsDark = isDark;
            seat.User.Settle();
            Assert.Empty(Layout.Problems(seat.Window));
            seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", $"{name}-{(isDark ? "zh" : "en")}.png"));
        }

        (Texts.Current.Language, seat.Shell.IsDark) = (Language.English, false);
        seat.User.Settle();
    }
}
