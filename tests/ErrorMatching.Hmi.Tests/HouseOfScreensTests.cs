using System.Reflection;
using System.Text.RegularExpressions;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Platform;
using Avalonia.Styling;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Platform;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What holds of all screens.</summary>
public sealed partial class HouseOfScreensTests
{
    private const double LeastContrast = 4.5, MostContrast = 7;

    private static readonly (string Ink, string Ground)[] Read =
    [
        ("Ink", "Ground"), ("Ink", "Surface"), ("Ink", "SurfaceQuiet"), ("Ink", "AccentGround"), ("Ink", "AttentionGround"),
        ("Ink", "AlarmGround"), ("InkQuiet", "Ground"), ("InkQuiet", "Surface"),
        ("InkQuiet", "SurfaceQuiet"), ("InkQuiet", "AttentionGround"), ("InkQuiet", "AlarmGround"), ("Accent", "AccentGround"),
        ("OnAccent", "Accent"), ("Good", "Surface"),
        ("Attention", "Surface"), ("Attention", "AttentionGround"), ("Alarm", "Surface"), ("Alarm", "AlarmGround"),
        ("PlotPart", "Surface"), ("PlotPart", "PlotGap"), ("PlotCounterpart", "Surface"), ("PlotCounterpart", "PlotGap"),
        ("PlotBefore", "Surface"), ("PlotBefore", "PlotBand"), ("PlotAfter", "Surface"), ("PlotAfter", "PlotBand"),
    ];

    // Numbers in drawings that are no lengths: micrometers of a millimeter, the units of a schematic drawing, what is as good as zero,
    // bits and dots of a bitmap, a time.
    private static readonly string[] NoLengths = [
        "1000 * LimitMm", "Step = 10, Depth = 12", "1e-6", "1e-9", "new(96, 96)", "<< 24", "<< 16", "<< 8", "FromMilliseconds(40)"];

    [Fact]
    public void View_models_know_no_Avalonia()
    {
        var models = typeof(ShellViewModel).Assembly.GetTypes()
            .Where(
                t => typeof(Observable).IsAssignableFrom(t)
                    || t.Name.EndsWith("Row", StringComparison.Ordinal)
                    || t.Name.EndsWith("Tile", StringComparison.Ordinal)
                    || t.Name.StartsWith("Stored", StringComparison.Ordinal))
            .ToArray();
        Assert.True(models.Length > 15);
        Assert.All(
            models,
            m => Assert.All(
                Used(m),
                t => Assert.False(
                    t.Assembly.GetName().Name!.StartsWith("Avalonia", StringComparison.Ordinal), $"{m.Name} uses {t.FullName}")));
    }

    [Fact]
    public void Each_screen_has_a_view()
    {
        var shown = Views.ViewModels.ToHashSet();
        Assert.All(
            typeof(ScreenViewModel).Assembly.GetTypes().Where(t => typeof(ScreenViewModel).IsAssignableFrom(t) && !t.IsAbstract),
            t => Assert.Contains(t, shown));
    }

    [Fact]
    public void Colors_and_lengths_are_in_the_styles_alone()
    {
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Hmi"), "*.axaml", SearchOption.AllDirectories)
            .Where(
                f => !f.Contains($"{Path.DirectorySeparatorChar}Styles{Path.DirectorySeparatorChar}", StringComparison.Ordinal)
                    && !f.EndsWith("App.axaml", StringComparison.Ordinal)))
        {
            Assert.All(
                Inline().Matches(File.ReadAllText(file)).Select(m => m.Value), v => Assert.Fail($"{Path.GetFileName(file)} has {v}."));
        }
    }

    [Fact]
    public void Drawings_have_no_colors_of_their_own()
    {
        var files = Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Hmi"), "*.cs", SearchOption.AllDirectories)
            .Where(f => !f.Contains($"{Path.DirectorySeparatorChar}Styles{Path.DirectorySeparatorChar}", StringComparison.Ordinal))
            .ToArray();
        Assert.True(files.Length > 100);
        Assert.All(
            files,
            f => Assert.All(
                InlineInCode().Matches(File.ReadAllText(f)).Select(m => m.Value), v => Assert.Fail($"{Path.GetFileName(f)} has {v}.")));
    }

    [Fact]
    public void Drawings_have_no_lengths_of_their_own()
    {
        var files = new[]
        {
            ("Drawings", "*.cs"),
            ("Plots", "*.cs"),
            ("Programs", "Path*.cs"),
            ("Programs", "ProgramRows.cs"),
            ("Programs", "ProgramText*.cs")
        }.SelectMany(p => Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Hmi", p.Item1), p.Item2)).ToArray();
        Assert.True(files.Length > 30);
        foreach (var (file, line) in files.SelectMany(
            f => File.ReadLines(f).Select(l => (Path.GetFileName(f), Line: NoCode().Replace(l, "")))))
        {
            Assert.False(LengthOfItsOwn().IsMatch(line), $"{file}: a length of its own in{line}");
            Assert.All(
                Number().Matches(NoLengths.Aggregate(
                    NamedShare().Replace(line, ""), (l, n) => l.Replace(n, "", StringComparison.Ordinal))).Select(m => m.Value),
                v => Assert.Fail($"{file} has {v} in{line}"));
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Text_can_be_told_from_its_ground(bool isDark) => Drawing.Needed().RunAsync(() =>
    {
        var theme = isDark ? ThemeVariant.Dark : ThemeVariant.Light;
        Assert.All(
            Read,
            r => Assert.True(
                Contrast(Color(r.Ink), Color(r.Ground)) >= LeastContrast,
                $"{r.Ink} on {r.Ground}: {Contrast(Color(r.Ink), Color(r.Ground)):0.00}"));

        Color Color(string key) => Of(key, theme);
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task With_high_contrast_everything_stands_out(bool isDark) => Drawing.Needed().RunAsync(() =>
    {
        var theme = isDark ? HighContrast.Dark : HighContrast.Light;
        Assert.All<(string Ink, string Ground)>(
            [.. Read, ("Line", "Surface"), ("Line", "Ground"), ("TabItemHeaderForegroundUnselected", "Ground")],
            r => Assert.True(
                Contrast(Color(r.Ink), Color(r.Ground)) >= MostContrast,
                $"{r.Ink} on {r.Ground}: {Contrast(Color(r.Ink), Color(r.Ground)):0.00}"));

        Color Color(string key) => Of(key, theme);
    });

    [Fact]
    public Task High_contrast_of_the_system_goes_before_the_theme_of_the_user() => Seat.AtAsync(seat =>
    {
        var system = OffScreenSettings.Current;
        try
        {
            Assert.Equal(ThemeVariant.Light, seat.Window.ActualThemeVariant);
            system.Choose(ColorContrastPreference.High, PlatformThemeVariant.Dark);
            Assert.Equal(HighContrast.Dark, seat.Window.ActualThemeVariant);
            Assert.Equal(Of("Ground", HighContrast.Dark), ((ISolidColorBrush)seat.Window.Background!).Color);
            seat.Shell.IsDark = true;
            system.Choose(ColorContrastPreference.High, PlatformThemeVariant.Light);
            Assert.Equal(HighContrast.Light, seat.Window.ActualThemeVariant);
        }
        finally
        {
            system.Choose(ColorContrastPreference.NoPreference, PlatformThemeVariant.Light);
        }

        Assert.Equal(ThemeVariant.Dark, seat.Window.ActualThemeVariant);
    });

    [Fact]
    public Task Without_animations_nothing_changes_gradually() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-overview");
        var gradual = Gradual();
        Assert.NotEmpty(gradual);
        Application.Current!.Styles.Add(Win32Settings.Still);
        try
        {
            seat.User.Settle();
            Assert.Empty(Gradual());
        }
        finally
        {
            Assert.True(Application.Current.Styles.Remove(Win32Settings.Still));
        }

        seat.User.Settle();
        Assert.Equal(gradual.Length, Gradual().Length);

        // What is hidden gets its styles when it is shown.
        Control[] Gradual() =>
            [.. seat.Window.GetVisualDescendants().OfType<Control>().Where(c => c.IsEffectivelyVisible && c.Transitions is { Count: > 0 })];
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Nothing_in_a_plot_looks_like_a_warning_but_what_is_between_two_pieces(bool isDark) => Drawing.Needed().RunAsync(() =>
    {
        // Amber and red have more red than blue; grays, blues and greens have not.
        const int Warm = 24;
        var theme = isDark ? ThemeVariant.Dark : ThemeVariant.Light;
        Assert.All(["Attention", "Alarm", "PlotGap"], k => Assert.True(Color(k).R > Color(k).B + Warm, k));
        Assert.All(
            ["PlotTheoretical", "PlotBefore", "PlotAfter", "PlotPart", "PlotCounterpart", "PlotBand"],
            k => Assert.True(Color(k).R <= Color(k).B + Warm, k));

        Color Color(string key) => Of(key, theme);
    });

    private static Color Of(string key, ThemeVariant theme) =>
        Application.Current!.TryGetResource(key, theme, out var brush)
            ? ((ISolidColorBrush)brush!).Color
            : throw new KeyNotFoundException(key);

    // WCAG 2.1, 1.4.3: relative luminance and contrast ratio.
    private static double Contrast(Color a, Color b)
    {
        var (la, lb) = (Luminance(a), Luminance(b));
        return (Math.Max(la, lb) + 0.05) / (Math.Min(la, lb) + 0.05);
    }

    private static double Luminance(Color c) => (0.2126 * Linear(c.R)) + (0.7152 * Linear(c.G)) + (0.0722 * Linear(c.B));

    private static double Linear(byte value) => value / 255.0 is var v && v <= 0.04045 ? v / 12.92 : Math.Pow((v + 0.055) / 1.055, 2.4);

    private static IEnumerable<Type> Used(Type type)
    {
        const BindingFlags All = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static
            | BindingFlags.DeclaredOnly;
        return type.GetFields(All).Select(f => f.FieldType)
            .Concat(type.GetProperties(All).Select(p => p.PropertyType))
            .Concat(type.GetMethods(All).SelectMany(m => m.GetParameters().Select(p => p.ParameterType).Append(m.ReturnType)))
            .Append(type.BaseType!);
    }

    [GeneratedRegex(
        """(Margin|Padding|Width|Height|FontSize|Spacing|CornerRadius|BorderThickness|StrokeThickness)="[0-9.,\- ]+"|"#[0-9A-Fa-f]{3,8}"|(Background|Foreground|Fill|Stroke|BorderBrush)="[A-Z][a-z]+"|(Column|Row)Definitions="[^"]*[0-9](?![0-9*.])[^"]*" """,
        RegexOptions.None | RegexOptions.ExplicitCapture,
        1000)]
    private static partial Regex Inline();

    [GeneratedRegex(
        """\b(Brushes|Colors)\.[A-Z][A-Za-z]*|\bColor\.(Parse|From[A-Za-z0-9]+)|"#[0-9A-Fa-f]{3,8}["]""",
        RegexOptions.None | RegexOptions.ExplicitCapture,
        1000)]
    private static partial Regex InlineInCode();

    // Comments and strings, with the numbers in them.
    [GeneratedRegex("""\s*//.*|"([^"\\]|\\.)*"|'[^']*'""", RegexOptions.None | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex NoCode();

    // Shares and factors say by their names that they are none, counts by their type.
    [GeneratedRegex(
        """const double (\w*(Share|Factor) = [0-9./ ]+(, )?)+;|const int .*""", RegexOptions.None | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex NamedShare();

    [GeneratedRegex(
        """const double (?!\w*(Share|Factor)\b)(?!Step = 10)|DashStyle\(|DashStyle \w+ = new""",
        RegexOptions.None | RegexOptions.ExplicitCapture,
        1000)]
    private static partial Regex LengthOfItsOwn();

    // Neither ends and halves nor an index.
    [GeneratedRegex(
        """(?<![\w.])(?!(0|1|2|0\.5|0\.0|1\.0)(?![\w.]))(?<!\[(?=[0-9]+\]))[0-9]+(\.[0-9]+)?(e-?[0-9]+)?(?!\w)""",
        RegexOptions.None | RegexOptions.ExplicitCapture,
        1000)]
    private static partial Regex Number();
}
