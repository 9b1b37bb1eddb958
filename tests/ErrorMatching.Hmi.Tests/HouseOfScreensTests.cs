using System.Reflection;
using System.Text.RegularExpressions;
using Avalonia;
using Avalonia.Media;
using Avalonia.Styling;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What holds of all screens.</summary>
public sealed partial class HouseOfScreensTests
{
    private const double LeastContrast = 4.5;

    private static readonly (string Ink, string Ground)[] Read =
    [
        ("Ink", "Ground"), ("Ink", "Surface"), ("Ink", "SurfaceQuiet"), ("Ink", "AccentGround"), ("Ink", "AttentionGround"), ("Ink", "AlarmGround"), ("InkQuiet", "Ground"), ("InkQuiet", "Surface"),
        ("InkQuiet", "SurfaceQuiet"), ("InkQuiet", "AttentionGround"), ("InkQuiet", "AlarmGround"), ("Accent", "AccentGround"), ("OnAccent", "Accent"), ("Attention", "Surface"), ("Attention", "AttentionGround"), ("Alarm", "Surface"), ("Alarm", "AlarmGround"),
    ];

    [Fact]
    public void View_models_know_no_Avalonia()
    {
        var models = typeof(ShellViewModel).Assembly.GetTypes().Where(t => typeof(Observable).IsAssignableFrom(t) || t.Name.EndsWith("Row", StringComparison.Ordinal) || t.Name.EndsWith("Tile", StringComparison.Ordinal) || t.Name.StartsWith("Kept", StringComparison.Ordinal)).ToArray();
        Assert.True(models.Length > 15);
        Assert.All(models, m => Assert.All(Used(m), t => Assert.False(t.Assembly.GetName().Name!.StartsWith("Avalonia", StringComparison.Ordinal), $"{m.Name} uses {t.FullName}")));
    }

    [Fact]
    public void Each_screen_has_a_view()
    {
        var shown = Views.ViewModels.ToHashSet();
        Assert.All(typeof(ScreenViewModel).Assembly.GetTypes().Where(t => typeof(ScreenViewModel).IsAssignableFrom(t) && !t.IsAbstract), t => Assert.Contains(t, shown));
    }

    [Fact]
    public void Colors_and_lengths_are_in_the_styles_alone()
    {
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Hmi"), "*.axaml", SearchOption.AllDirectories).Where(f => !f.Contains($"{Path.DirectorySeparatorChar}Styles{Path.DirectorySeparatorChar}", StringComparison.Ordinal) && !f.EndsWith("App.axaml", StringComparison.Ordinal)))
        {
            Assert.All(Inline().Matches(File.ReadAllText(file)).Select(m => m.Value), v => Assert.Fail($"{Path.GetFileName(file)} has {v}."));
        }
    }

    [Fact]
    public void Drawings_have_no_colors_of_their_own()
    {
        var files = Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Hmi"), "*.cs", SearchOption.AllDirectories).Where(f => !f.Contains($"{Path.DirectorySeparatorChar}Styles{Path.DirectorySeparatorChar}", StringComparison.Ordinal)).ToArray();
        Assert.True(files.Length > 100);
        Assert.All(files, f => Assert.All(InlineInCode().Matches(File.ReadAllText(f)).Select(m => m.Value), v => Assert.Fail($"{Path.GetFileName(f)} has {v}.")));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Text_can_be_told_from_its_ground(bool isDark) => Drawing.Needed().RunAsync(() =>
    {
        var theme = isDark ? ThemeVariant.Dark : ThemeVariant.Light;
        Assert.All(Read, r => Assert.True(Contrast(Color(r.Ink), Color(r.Ground)) >= LeastContrast, $"{r.Ink} on {r.Ground}: {Contrast(Color(r.Ink), Color(r.Ground)):0.00}"));

        Color Color(string key) => Application.Current!.TryGetResource(key, theme, out var brush) ? ((ISolidColorBrush)brush!).Color : throw new KeyNotFoundException(key);
    });

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
        const BindingFlags All = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
        return type.GetFields(All).Select(f => f.FieldType)
            .Concat(type.GetProperties(All).Select(p => p.PropertyType))
            .Concat(type.GetMethods(All).SelectMany(m => m.GetParameters().Select(p => p.ParameterType).Append(m.ReturnType)))
            .Append(type.BaseType!);
    }

    [GeneratedRegex("""(Margin|Padding|Width|Height|FontSize|Spacing|CornerRadius|BorderThickness|StrokeThickness)="[0-9.,\- ]+"|"#[0-9A-Fa-f]{3,8}"|(Background|Foreground|Fill|Stroke|BorderBrush)="[A-Z][a-z]+"|(Column|Row)Definitions="[^"]*[0-9](?![0-9*.])[^"]*" """, RegexOptions.None | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Inline();

    [GeneratedRegex("""\b(Brushes|Colors)\.[A-Z][A-Za-z]*|\bColor\.(Parse|From[A-Za-z0-9]+)|"#[0-9A-Fa-f]{3,8}["]""", RegexOptions.None | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex InlineInCode();
}
