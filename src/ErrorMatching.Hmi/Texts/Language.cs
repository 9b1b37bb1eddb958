namespace ErrorMatching.Hmi;

/// <summary>A display language.</summary>
public enum Language
{
    English,

    /// <summary>Chinese as written in Taiwan.</summary>
    TraditionalChinese,
}
