namespace ErrorMatching.Hmi;

/// <summary>A language of the screen.</summary>
public enum Language
{
    /// <summary>English.</summary>
    English,

    /// <summary>Chinese as written in Taiwan.</summary>
    TraditionalChinese,
}
