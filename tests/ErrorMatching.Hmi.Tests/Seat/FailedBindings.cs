using Avalonia.Logging;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Bindings whose value a property does not take. Avalonia only logs them, and the screen lacks what they should show.</summary>
internal sealed class FailedBindings : ILogSink
{
    // What is not there yet, such as the details before something is chosen.
    private const string Nothing = "Value is null.";
    private readonly HashSet<string> _found = [];

    private FailedBindings()
    {
    }

    /// <summary>Those of the process.</summary>
    public static FailedBindings Seen { get; } = new();

    /// <summary>What was found since it was asked for last.</summary>
    public IReadOnlyList<string> Take()
    {
        lock (_found)
        {
            string[] taken = [.. _found.Order(StringComparer.Ordinal)];
            _found.Clear();
            return taken;
        }
    }

    /// <inheritdoc/>
    public bool IsEnabled(LogEventLevel level, string area) => area == LogArea.Binding && level >= LogEventLevel.Warning;

    /// <inheritdoc/>
    public void Log(LogEventLevel level, string area, object? source, string messageTemplate) =>
        Log(level, area, source, messageTemplate, []);

    /// <inheritdoc/>
    public void Log(LogEventLevel level, string area, object? source, string messageTemplate, params object?[] propertyValues)
    {
        if (IsEnabled(level, area) && propertyValues.LastOrDefault() is not Nothing)
        {
            lock (_found)
            {
                _found.Add($"{source?.GetType().Name}: {messageTemplate} {string.Join(", ", propertyValues)}");
            }
        }
    }
}
