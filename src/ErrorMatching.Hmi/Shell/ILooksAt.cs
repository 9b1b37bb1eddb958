namespace ErrorMatching.Hmi;

/// <summary>A screen that can be opened at one correction.</summary>
public interface ILooksAt
{
    /// <summary>Shows it.</summary>
    /// <param name="correction">Its number.</param>
    void LookAt(long correction);
}
