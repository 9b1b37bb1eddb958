using Avalonia.Data;
using Avalonia.Markup.Xaml;

namespace ErrorMatching.Hmi;

/// <summary>A text by its key in a view: <c>Text="{l:Text Overview.Waiting}"</c>. It follows the language.</summary>
/// <param name="key">The key.</param>
public sealed class TextExtension(string key) : MarkupExtension
{
    /// <summary>The key.</summary>
    public string Key { get; } = key;

    /// <inheritdoc/>
    public override object ProvideValue(IServiceProvider serviceProvider)
    {
        // A key that is not there shows here, when the view is made, and not where somebody sees a gap.
        _ = Texts.Current[Key];
        return new ReflectionBinding($"[{Key}]") { Source = Texts.Current, Mode = BindingMode.OneWay };
    }
}
