namespace ErrorMatching.Hmi;

/// <summary>A screen that can be opened at a correction.</summary>
internal interface ILooksAt
{
    /// <summary>Shows the correction.</summary>
    /// <param name="correction">Its number.</param>
    void LookAt(long correction);
}
