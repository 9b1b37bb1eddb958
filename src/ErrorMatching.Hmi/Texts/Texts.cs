using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Text.Json;
using System.Text.Json.Serialization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Hmi;

/// <summary>All texts of the station in the chosen language, from the files next to this one; each language has the same keys.</summary>
public sealed partial class Texts : Observable
{
    private static readonly Dictionary<Language, IReadOnlyDictionary<string, string>> All = Enum.GetValues<Language>().ToDictionary(
        l => l, l => (IReadOnlyDictionary<string, string>)Read(l));
    private Language _language;

    private Texts()
    {
    }

    /// <summary>Raised when another language is chosen.</summary>
    public event Action? LanguageChanged;

    public static Texts Current { get; } = new();

    /// <summary>The display language.</summary>
    public Language Language
    {
        get => _language;
        set
        {
            if (Set(ref _language, value))
            {
                // Both names: which one stands for the indexer depends on the listener.
                OnPropertyChanged("Item");
                OnPropertyChanged("Item[]");
                LanguageChanged?.Invoke();
            }
        }
    }

    /// <summary>The text of a key.</summary>
    /// <exception cref="KeyNotFoundException">There is no such key.</exception>
    public string this[string key] =>
        All[_language].TryGetValue(key, out var text) ? text : throw new KeyNotFoundException($"There is no text {key}.");

    /// <summary>All keys of a language with their texts.</summary>
    public static IReadOnlyDictionary<string, string> Of(Language language) => All[language];

    /// <summary>The text of a key, with values for <c>{0}</c> and so on.</summary>
    /// <exception cref="KeyNotFoundException">There is no such key.</exception>
    public string With(string key, params object[] values) => Unparted(string.Format(CultureInfo.InvariantCulture, this[key], values));

    /// <summary>The text of a key for a count; for 1, the text of the key with <c>One</c> appended.</summary>
    /// <param name="key">The key.</param>
    /// <param name="count">The count.</param>
    /// <param name="values">Values for <c>{0}</c> and so on.</param>
    /// <exception cref="KeyNotFoundException">There is no such key.</exception>
    public string Counted(string key, int count, params object[] values) => With(count == 1 ? key + "One" : key, values);

    /// <summary>Joins words to a list in the style of the language.</summary>
    /// <param name="words">The words.</param>
    public string Listed(IEnumerable<string> words) => string.Join(this["List.Between"], words);

    /// <summary>The text of a value of an enumeration, by the key TYPE.VALUE.</summary>
    public string Word<T>(T value)
        where T : struct, Enum => this[$"{typeof(T).Name}.{value}"];

    /// <summary>The text of a key, or a fallback if there is none.</summary>
    public string Or(string key, string otherwise) => All[_language].GetValueOrDefault(key, otherwise);

    private static Dictionary<string, string> Read(Language language)
    {
        using var stream = typeof(Texts).Assembly.GetManifestResourceStream("texts." + (language == Language.English ? "en" : "zh-Hant"))!;
        var texts = JsonSerializer.Deserialize(stream, TextsJson.Default.DictionaryStringString)!;
        return texts.ToDictionary(t => t.Key, t => Unparted(t.Value));
    }

    // Keeps a number and its unit on one line.
    private static string Unparted(string text) => BeforeUnit().Replace(text, "\u00a0");

    [GeneratedRegex(@"(?<=[\d}]) (?=(mm|µm)\b)", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex BeforeUnit();
}

/// <summary>How the texts are read, made while the program is compiled.</summary>
[JsonSerializable(typeof(Dictionary<string, string>))]
[SuppressMessage("ApiDesign", "RS0030", Justification = "The generated code names a type without a culture.")]
internal sealed partial class TextsJson : JsonSerializerContext;
