using Avalonia;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What a seat shows in both themes, both languages and two sizes:
/// what measure finds wrong with it, and pictures for people in artifacts/screenshots.</summary>
internal sealed class Pictures(Seat seat)
{
    private readonly List<string> _problems = [];

    /// <summary>What is wrong, with screen, size and language, each once.</summary>
    public IReadOnlyList<string> Problems => [.. _problems.Distinct()];

    /// <summary>Looks at what is shown now.</summary>
    /// <param name="name">Name of the screen, with which its pictures begin.</param>
    /// <param name="isPictured">False for what differs in content only: then two pictures are made instead of four. All sizes and
    /// languages are measured all the same.</param>
    /// <param name="settled">What is waited for in each language: words that are made beside the screen.</param>
    /// <param name="isMeasured">False for the keyboard, which lies over the screen on purpose.</param>
    public void Take(string name, bool isPictured = true, Func<bool>? settled = null, bool isMeasured = true)
    {
        // Nothing is meant to be pointed at.
        seat.User.MoveTo(seat.Window, new(1, 1));
        foreach (var size in new Size[] { new(1280, 800), new(1920, 1080) })
        {
            (seat.Window.Width, seat.Window.Height) = (size.Width, size.Height);
            foreach (var (language, code) in new[] { (Language.English, "en"), (Language.TraditionalChinese, "zh") })
            {
                Texts.Current.Language = language;
                seat.User.Settle();
                seat.WaitFor(settled ?? (() => true), $"{name} is not made anew in another language.");
                _problems.AddRange(
                    (isMeasured ? Layout.Problems(seat.Window) : []).Select(p => $"{name} {size.Width}x{size.Height} {code}: {p}"));
                foreach (var isDark in new[] { false, true })
                {
                    if (IsPictured(isPictured, size.Width > 1500, language == Language.TraditionalChinese, isDark))
                    {
                        seat.Shell.IsDark = isDark;
                        var picture = Repository.PathTo(
                            "artifacts", "screenshots", $"{name}-{(isDark ? "dark" : "light")}-{code}-{size.Width}x{size.Height}.png");
                        seat.User.Screenshot(picture);
                        Keep(name, code, picture);
                    }
                }
            }
        }

        seat.Shell.IsDark = false;
        Texts.Current.Language = Language.English;
        (seat.Window.Width, seat.Window.Height) = (1280, 800);
        seat.User.Settle();
    }

    // A theme changes no layout: each language in each, and what the manual shows, in the small window; the large one once.
    private static bool IsPictured(bool isPictured, bool isLarge, bool isChinese, bool isDark) =>
        isLarge ? isPictured && isDark && !isChinese : isDark == isChinese || (isPictured && !isDark);

    // The manual's pictures are the small window's, one for each language; they are renewed when somebody asks for it.
    private static void Keep(string name, string code, string picture)
    {
        var kept = Repository.PathTo("docs", "station", "pictures", $"{name}-{code}.png");
        if (Environment.GetEnvironmentVariable("UPDATE_MANUAL") == "1"
            && File.Exists(kept)
            && picture.EndsWith($"-light-{code}-1280x800.png", StringComparison.Ordinal))
        {
            File.Copy(picture, kept, overwrite: true);
        }
    }

    /// <summary>Fails with everything that was found.</summary>
    public void MustBeClean() => Assert.True(_problems.Count == 0, string.Join('\n', Problems));
}
