using Avalonia;
using Avalonia.Data.Converters;

namespace ErrorMatching.Hmi;

/// <summary>Icons by what a view model says of them.</summary>
public static class Icons
{
    /// <summary>From a key to the icon.</summary>
    public static IValueConverter ByKey { get; } = new FuncValueConverter<string?, Avalonia.Media.Geometry?>(Find);

    /// <summary>From a severity to its icon.</summary>
    public static IValueConverter BySeverity { get; } = new FuncValueConverter<Severity, Avalonia.Media.Geometry?>(
        s => Find("Icon." + Name(s)));

    /// <summary>True for what waits for a person.</summary>
    public static IValueConverter IsAttention { get; } = new FuncValueConverter<Severity, bool>(s => s == Severity.Attention);

    /// <summary>True for what keeps something from working.</summary>
    public static IValueConverter IsAlarm { get; } = new FuncValueConverter<Severity, bool>(s => s == Severity.Alarm);

    private static string Name(Severity severity) =>
        severity switch { Severity.Alarm => "alarm", Severity.Attention => "attention", _ => "quiet" };

    private static Avalonia.Media.Geometry? Find(string? key) =>
        key is not null && Application.Current!.TryGetResource(key, null, out var icon) ? icon as Avalonia.Media.Geometry : null;
}
