using System.Collections.Concurrent;
using Avalonia.Data;
using Avalonia.Data.Core;
using Avalonia.Markup.Xaml;
using Avalonia.Markup.Xaml.MarkupExtensions.CompiledBindings;

namespace ErrorMatching.Hmi;

/// <summary>A text by its key in a view: <c>Text="{l:Text Overview.Waiting}"</c>. It follows the language.</summary>
/// <param name="key">The key.</param>
public sealed class TextExtension(string key) : MarkupExtension
{
    // A screen has dozens of texts: what leads to one is made once.
    private static readonly ConcurrentDictionary<string, CompiledBindingPath> Paths = new(StringComparer.Ordinal);

    /// <summary>The key.</summary>
    public string Key { get; } = key;

    /// <inheritdoc/>
    public override object ProvideValue(IServiceProvider serviceProvider)
    {
        // A key that is not there shows here, when the view is made, and not where somebody sees a gap.
        _ = Texts.Current[Key];
        return new CompiledBinding(Paths.GetOrAdd(Key, Path)) { Source = Texts.Current, Mode = BindingMode.OneWay };
    }

    private static CompiledBindingPath Path(string key) =>
        new CompiledBindingPathBuilder().Property(new ClrPropertyInfo("Item", texts => ((Texts)texts)[key], null, typeof(string)), PropertyInfoAccessorFactory.CreateInpcPropertyAccessor).Build();
}
