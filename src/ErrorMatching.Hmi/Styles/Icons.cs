using Avalonia;
using Avalonia.Data.Converters;

namespace ErrorMatching.Hmi;

/// <summary>Converters from view model values to icons.</summary>
internal static class Icons
{
    public static IValueConverter ByKey { get; } = new FuncValueConverter<string?, Avalonia.Media.Geometry?>(Find);

    public static IValueConverter BySeverity { get; } = new FuncValueConverter<Severity, Avalonia.Media.Geometry?>(
        s => Find("Icon." + Name(s)));

    /// <summary>True for what waits for the user.</summary>
    public static IValueConverter IsAttention { get; } = new FuncValueConverter<Severity, bool>(s => s == Severity.Attention);

    /// <summary>True for what prevents operation.</summary>
    public static IValueConverter IsAlarm { get; } = new FuncValueConverter<Severity, bool>(s => s == Severity.Alarm);

    private static string Name(Severity severity) =>
        severity switch { Severity.Alarm => "alarm", Severity.Attention => "attention", _ => "quiet" };

    private static Avalonia.Media.Geometry? Find(string? key) =>
        key is not null && Application.Current!.TryGetResource(key, null, out var icon) ? icon as Avalonia.Media.Geometry : null;
}
