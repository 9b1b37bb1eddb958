using System.Collections.Concurrent;
using Avalonia.Data;
using Avalonia.Data.Core;
using Avalonia.Markup.Xaml;
using Avalonia.Markup.Xaml.MarkupExtensions.CompiledBindings;

namespace ErrorMatching.Hmi;

/// <summary>A text by its key in a view: <c>Text="{l:Text Overview.Waiting}"</c>. It follows the language.</summary>
/// <param name="key">The key.</param>
internal sealed class TextExtension(string key) : MarkupExtension
{
    // A screen has dozens of texts: each binding path is created once.
    private static readonly ConcurrentDictionary<string, CompiledBindingPath> Paths = new(StringComparer.Ordinal);

    public string Key { get; } = key;

    /// <inheritdoc/>
    public override object ProvideValue(IServiceProvider serviceProvider) => Bind(Key);

    /// <summary>The same for a property that is bound in code.</summary>
    /// <param name="key">The key.</param>
    public static CompiledBinding Bind(string key)
    {
        // A missing key fails here, when the view is created, instead of leaving a gap on the screen.
        _ = Texts.Current[key];
        return new CompiledBinding(Paths.GetOrAdd(key, Path)) { Source = Texts.Current, Mode = BindingMode.OneWay };
    }

    private static CompiledBindingPath Path(string key) =>
        new CompiledBindingPathBuilder().Property(
            new ClrPropertyInfo("Item", texts => ((Texts)texts)[key], null, typeof(string)),
            PropertyInfoAccessorFactory.CreateInpcPropertyAccessor).Build();
}
