namespace ErrorMatching.Json;

/// <summary>The kind of a JSON value.</summary>
public enum JsonItemKind
{
    /// <summary>The word null.</summary>
    Null,

    /// <summary>True or false.</summary>
    Boolean,

    /// <summary>A number.</summary>
    Number,

    /// <summary>Text in quotes.</summary>
    Text,

    /// <summary>A list in square brackets.</summary>
    List,

    /// <summary>An object in braces.</summary>
    Object,
}
